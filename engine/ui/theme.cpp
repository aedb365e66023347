#include "lanthorn/ui/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>

#include "lanthorn/core/installation.h"

namespace lanthorn::ui {

namespace fs = std::filesystem;

namespace {

// Latin with its accents, and dashes and quotation marks.
constexpr std::array<ImWchar, 5> kLetters = {0x20, 0xff, 0x2010, 0x2026, 0};

// Ranges of the letters of a text, which ImGui's atlas keeps a pointer to.
const ImWchar* letters_of(const std::string& text) {
    static std::map<std::string, ImVector<ImWchar>> known;
    const auto [at, is_new] = known.try_emplace(text);
    if (is_new) {
        ImFontGlyphRangesBuilder builder;
        builder.AddText(text.c_str());
        builder.BuildRanges(&at->second);
    }
    return at->second.Data;
}

fs::path font_file(std::string_view name, std::string_view package) {
    const fs::path share = installed_share();
    std::error_code error;
    for (const fs::path& folder :
         {share.empty() ? fs::path() : share / "fonts", fs::path("/usr/share/fonts/opentype") / package}) {
        if (!folder.empty() && fs::is_regular_file(folder / name, error)) {
            return folder / name;
        }
    }
    return {};
}

// An empty `file` gives ImGui's own bitmap. `letters`: pairs of first and last, ended by 0; must outlive the
// atlas.
ImFont* add_font(const fs::path& file, float height, const ImWchar* letters) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    if (file.empty()) {
        ImFontConfig config;
        config.SizePixels = std::max(13.0f, 13 * std::floor(height / 13));  // a bitmap: whole multiples
        return atlas.AddFontDefault(&config);
    }
    return atlas.AddFontFromFileTTF(file.c_str(), std::round(height), nullptr, letters);
}

ImFont* add_face(const Face& face, float unit, std::string* missing) {
    const fs::path file = font_file(face.file, face.package);
    if (file.empty() && *face.file != '\0') {
        *missing = face.file;
    }
    const std::string letters = face.letters;
    return add_font(file, face.height * unit, letters.empty() ? kLetters.data() : letters_of(letters));
}

ImVec4 with(const vec3& colour, float alpha) {
    return {colour.x, colour.y, colour.z, alpha};
}

}  // namespace

float unit_of(ivec2 window, double text_size) {
    const float fit = std::min(static_cast<float>(window.x) / 1280, static_cast<float>(window.y) / 720);
    // Letters of less than about 12 pixels cannot be read.
    return std::clamp(fit * static_cast<float>(text_size), 0.6f, 8.0f);
}

Fonts load_fonts(const Theme& theme, float unit, std::string* missing) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.TexGlyphPadding = 2;
    Fonts fonts;
    fonts.text = add_face(theme.text, unit, missing);
    fonts.heading = add_face(theme.heading, unit, missing);
    fonts.title = add_face(theme.title, unit, missing);
    ImGui::GetIO().FontDefault = fonts.text;
    return fonts;
}

void apply_style(const Theme& theme, float unit) {
    const auto pair = [](const vec2& v) { return ImVec2(v.x, v.y); };
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    style.WindowPadding = pair(theme.window_padding);
    style.FramePadding = pair(theme.frame_padding);
    style.ItemSpacing = pair(theme.item_spacing);
    style.WindowRounding = theme.window_rounding;
    style.FrameRounding = theme.frame_rounding;
    style.ScrollbarSize = theme.scrollbar;
    style.ScrollbarRounding = theme.scrollbar / 2;
    style.WindowBorderSize = 0;
    style.ScaleAllSizes(unit);
    // Not less than a pixel where units are small.
    style.ScrollbarSize = std::max(style.ScrollbarSize, 6.0f);
    const auto set = [&](ImGuiCol which, const vec3& colour, float alpha) {
        style.Colors[which] = with(colour, alpha);
    };
    set(ImGuiCol_Text, theme.words, 1);
    set(ImGuiCol_TextDisabled, theme.faint, 1);
    set(ImGuiCol_WindowBg, theme.behind, theme.window_darkness);
    set(ImGuiCol_ScrollbarBg, theme.behind, 0);
    set(ImGuiCol_ScrollbarGrab, theme.faint, 0.35f);
    set(ImGuiCol_ScrollbarGrabHovered, theme.chosen, 0.5f);
    set(ImGuiCol_ScrollbarGrabActive, theme.chosen, 0.7f);
    set(ImGuiCol_NavHighlight, theme.chosen, 0);  // entries show themselves that they are chosen
}

ImU32 packed(const vec3& colour, float alpha) {
    return ImGui::ColorConvertFloat4ToU32(with(colour, alpha));
}

}  // namespace lanthorn::ui
