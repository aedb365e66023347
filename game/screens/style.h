// How menus and words look: fonts, colours, sizes. Quiet and warm, and legible over any picture.
#pragma once

#include <imgui.h>

#include <string>

#include "lanthorn/ui/fonts.h"

namespace lanthorn::game::ui {

// Sizes follow the window; small ones scroll.
using lanthorn::ui::unit_of;

struct Fonts {
    ImFont* text = nullptr;
    ImFont* heading = nullptr;
    ImFont* title = nullptr;  // has only the letters of the game's name
};

inline constexpr const char* kName = "lamplighter";

// Puts the fonts for `unit` into the current ImGui context's atlas, in the place of those there are, and
// returns them; the backend's texture is to be made anew. Where a font file is missing ImGui's own takes its
// place, and `missing` names it.
Fonts load_fonts(float unit, std::string* missing);

// Colours and spaces of the current ImGui context for `unit`.
void apply_style(float unit);

// Colours, sRGB; `alpha` 0..1 on top of their own.
ImU32 lamplight(float alpha = 1);  // what is chosen, what glows
ImU32 parchment(float alpha = 1);  // words
ImU32 dust(float alpha = 1);       // words that matter less
ImU32 night(float alpha = 1);      // what lies behind words

}  // namespace lanthorn::game::ui
