#include "tools/editor/window/style.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <string>

namespace lanthorn::edit_window {

namespace {

// Latin and its accents, Greek, dashes, arrows, superscripts, less or equal.
constexpr std::array<ImWchar, 13> kLetters = {0x20,   0xff,   0x391,  0x3c9,  0x2010, 0x2026, 0x2070,
                                              0x2079, 0x2190, 0x2193, 0x2260, 0x2265, 0};

ImFont* add_font(const char* name, float height) {
    const std::filesystem::path file = std::filesystem::path("/usr/share/fonts/truetype/dejavu") / name;
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) {
        ImFontConfig config;
        config.SizePixels = std::max(13.0f, 13 * std::floor(height / 13));  // a bitmap: whole multiples
        return atlas.AddFontDefault(&config);
    }
    return atlas.AddFontFromFileTTF(file.c_str(), std::round(height), nullptr, kLetters.data());
}

}  // namespace

EditorFonts apply_editor_style(float unit) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    EditorFonts fonts;
    // ImGui's height is from the highest to the lowest letter: 15 of it are the 13 that people mean.
    fonts.text = add_font("DejaVuSans.ttf", 15 * unit);
    fonts.numbers = add_font("DejaVuSansMono.ttf", 14 * unit);
    io.FontDefault = fonts.text;
    io.ConfigInputTextCursorBlink = false;  // a blink would draw frames for nothing
    io.ConfigWindowsMoveFromTitleBarOnly = true;

    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsDark(&style);
    style.AntiAliasedFill = false;
    style.AntiAliasedLines = true;
    style.AntiAliasedLinesUseTex = true;
    style.WindowRounding = style.ChildRounding = style.FrameRounding = style.TabRounding = 0;
    style.PopupRounding = style.ScrollbarRounding = style.GrabRounding = 0;
    style.WindowBorderSize = style.FrameBorderSize = 0;
    style.WindowPadding = {6, 4};
    style.FramePadding = {5, 2};
    style.ItemSpacing = {6, 3};
    style.ItemInnerSpacing = {4, 3};
    style.CellPadding = {4, 1};
    style.IndentSpacing = 12;
    style.ScrollbarSize = 11;
    style.GrabMinSize = 8;
    style.ScaleAllSizes(unit);
    style.WindowMinSize = {1, 1};
    const auto set = [&](ImGuiCol which, ImU32 to) {
        style.Colors[which] = ImGui::ColorConvertU32ToFloat4(to);
    };
    set(ImGuiCol_WindowBg, colour::panel);
    set(ImGuiCol_ChildBg, 0);
    set(ImGuiCol_PopupBg, IM_COL32(0x1e, 0x1e, 0x1e, 255));
    set(ImGuiCol_Border, IM_COL32(0x48, 0x48, 0x48, 255));
    set(ImGuiCol_Text, colour::words);
    set(ImGuiCol_TextDisabled, colour::faint);
    set(ImGuiCol_FrameBg, IM_COL32(0x17, 0x17, 0x17, 255));
    set(ImGuiCol_FrameBgHovered, IM_COL32(0x34, 0x3c, 0x46, 255));
    set(ImGuiCol_FrameBgActive, IM_COL32(0x3a, 0x48, 0x58, 255));
    set(ImGuiCol_Button, IM_COL32(0x3a, 0x3a, 0x3a, 255));
    set(ImGuiCol_ButtonHovered, IM_COL32(0x4a, 0x56, 0x64, 255));
    set(ImGuiCol_ButtonActive, IM_COL32(0x2f, 0x6a, 0xa8, 255));
    set(ImGuiCol_Header, colour::chosen_row);
    set(ImGuiCol_HeaderHovered, IM_COL32(0x3a, 0x46, 0x52, 255));
    set(ImGuiCol_HeaderActive, IM_COL32(0x3a, 0x62, 0x88, 255));
    set(ImGuiCol_Tab, IM_COL32(0x20, 0x20, 0x20, 255));
    set(ImGuiCol_TabHovered, IM_COL32(0x4a, 0x56, 0x64, 255));
    set(ImGuiCol_TabActive, IM_COL32(0x2f, 0x50, 0x70, 255));
    set(ImGuiCol_TabUnfocused, IM_COL32(0x20, 0x20, 0x20, 255));
    set(ImGuiCol_TabUnfocusedActive, IM_COL32(0x2f, 0x50, 0x70, 255));
    set(ImGuiCol_TableHeaderBg, IM_COL32(0x1f, 0x1f, 0x1f, 255));
    set(ImGuiCol_TableRowBgAlt, IM_COL32(255, 255, 255, 8));
    set(ImGuiCol_CheckMark, colour::chosen);
    set(ImGuiCol_SliderGrab, IM_COL32(0x5a, 0x8a, 0xb8, 255));
    set(ImGuiCol_SliderGrabActive, IM_COL32(0x7a, 0xaa, 0xd8, 255));
    set(ImGuiCol_ModalWindowDimBg, IM_COL32(0, 0, 0, 120));
    return fonts;
}

}  // namespace lanthorn::edit_window
