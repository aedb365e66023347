#include "game/screens/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "lanthorn/core/installation.h"

namespace lanthorn::game::ui {

namespace {

namespace fs = std::filesystem;

// Cabin, a humanist sans serif, for words; Quattrocento, a sober Roman, for headings (both SIL Open Font
// License, packages fonts-cabin and fonts-quattrocento).
constexpr const char* kTextFont = "Cabin-Medium.otf";
constexpr const char* kHeadingFont = "Quattrocento-Regular.otf";
constexpr float kTextHeight = 21, kHeadingHeight = 31, kTitleHeight = 86;  // at 1280x720

// Latin with its accents, and dashes and quotation marks.
constexpr std::array<ImWchar, 5> kLetters = {0x20, 0xff, 0x2010, 0x2026, 0};

// Beside the program where it is installed, else where Debian's packages put it. Empty: nowhere.
fs::path font_file(const char* name) {
    const fs::path share = installed_share();
    std::error_code error;
    for (const fs::path& folder :
         {share.empty() ? fs::path() : share / "fonts", fs::path("/usr/share/fonts/opentype/cabin"),
          fs::path("/usr/share/fonts/opentype/quattrocento")}) {
        if (!folder.empty() && fs::is_regular_file(folder / name, error)) {
            return folder / name;
        }
    }
    return {};
}

ImFont* add_font(const char* name, float height, const ImWchar* letters, std::string* missing) {
    const fs::path file = font_file(name);
    if (file.empty()) {
        *missing = name;
        ImFontConfig config;
        config.SizePixels = std::max(13.0f, 13 * std::floor(height / 13));  // a bitmap: whole multiples
        return ImGui::GetIO().Fonts->AddFontDefault(&config);
    }
    return ImGui::GetIO().Fonts->AddFontFromFileTTF(file.c_str(), std::round(height), nullptr, letters);
}

constexpr vec3 kLamplight(0.980f, 0.760f, 0.420f);
constexpr vec3 kParchment(0.965f, 0.925f, 0.860f);
constexpr vec3 kDust(0.750f, 0.690f, 0.610f);
constexpr vec3 kNight(0.055f, 0.040f, 0.030f);

ImVec4 with(const vec3& colour, float alpha) {
    return {colour.x, colour.y, colour.z, alpha};
}
ImU32 packed(const vec3& colour, float alpha) {
    return ImGui::ColorConvertFloat4ToU32(with(colour, alpha));
}

}  // namespace

float unit_of(ivec2 window, double text_size) {
    const float fit = std::min(static_cast<float>(window.x) / 1280, static_cast<float>(window.y) / 720);
    // Letters of less than about 12 pixels cannot be read.
    return std::clamp(fit * static_cast<float>(text_size), 0.6f, 8.0f);
}

Fonts load_fonts(float unit, std::string* missing) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.TexGlyphPadding = 2;
    static ImVector<ImWchar> name_letters;
    if (name_letters.empty()) {
        ImFontGlyphRangesBuilder builder;
        builder.AddText(kName);
        builder.BuildRanges(&name_letters);
    }
    Fonts fonts;
    fonts.text = add_font(kTextFont, kTextHeight * unit, kLetters.data(), missing);
    fonts.heading = add_font(kHeadingFont, kHeadingHeight * unit, kLetters.data(), missing);
    fonts.title = add_font(kHeadingFont, kTitleHeight * unit, name_letters.Data, missing);
    ImGui::GetIO().FontDefault = fonts.text;
    return fonts;
}

void apply_style(float unit) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    style.WindowPadding = {24, 20};
    style.FramePadding = {14, 8};
    style.ItemSpacing = {12, 8};
    style.WindowRounding = 10;
    style.FrameRounding = 8;
    style.ScrollbarSize = 12;
    style.ScrollbarRounding = 6;
    style.WindowBorderSize = 0;
    style.ScaleAllSizes(unit);
    // Not less than a pixel where units are small.
    style.ScrollbarSize = std::max(style.ScrollbarSize, 6.0f);
    const auto set = [&](ImGuiCol which, const vec3& colour, float alpha) {
        style.Colors[which] = with(colour, alpha);
    };
    set(ImGuiCol_Text, kParchment, 1);
    set(ImGuiCol_TextDisabled, kDust, 1);
    set(ImGuiCol_WindowBg, kNight, 0.82f);
    set(ImGuiCol_ScrollbarBg, kNight, 0);
    set(ImGuiCol_ScrollbarGrab, kDust, 0.35f);
    set(ImGuiCol_ScrollbarGrabHovered, kLamplight, 0.5f);
    set(ImGuiCol_ScrollbarGrabActive, kLamplight, 0.7f);
    set(ImGuiCol_NavHighlight, kLamplight, 0);  // entries show themselves that they are chosen
}

ImU32 lamplight(float alpha) {
    return packed(kLamplight, alpha);
}
ImU32 parchment(float alpha) {
    return packed(kParchment, alpha);
}
ImU32 dust(float alpha) {
    return packed(kDust, alpha);
}
ImU32 night(float alpha) {
    return packed(kNight, alpha);
}

}  // namespace lanthorn::game::ui
