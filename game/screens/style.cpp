#include "game/screens/style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "lanthorn/ui/fonts.h"

namespace lanthorn::game::ui {

namespace {

// Cabin, a humanist sans serif, for words; Quattrocento, a sober Roman, for headings (both SIL Open Font
// License, packages fonts-cabin and fonts-quattrocento).
constexpr const char* kTextFont = "Cabin-Medium.otf";
constexpr const char* kHeadingFont = "Quattrocento-Regular.otf";
constexpr float kTextHeight = 21, kHeadingHeight = 31, kTitleHeight = 86;  // at 1280x720

// Latin with its accents, and dashes and quotation marks.
constexpr std::array<ImWchar, 5> kLetters = {0x20, 0xff, 0x2010, 0x2026, 0};

ImFont* add_font(const char* name, const char* package, float height, const ImWchar* letters,
                 std::string* missing) {
    const std::filesystem::path file = lanthorn::ui::font_file(name, package);
    if (file.empty()) {
        *missing = name;
    }
    return lanthorn::ui::add_font(file, height, letters);
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
    fonts.text = add_font(kTextFont, "cabin", kTextHeight * unit, kLetters.data(), missing);
    fonts.heading = add_font(kHeadingFont, "quattrocento", kHeadingHeight * unit, kLetters.data(), missing);
    fonts.title = add_font(kHeadingFont, "quattrocento", kTitleHeight * unit, name_letters.Data, missing);
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
