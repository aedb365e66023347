// How menus and words look: fonts, colours, spaces. A program declares its own looks as a Theme.
#pragma once

#include <imgui.h>

#include <string>

#include "lanthorn/core/math.h"

namespace lanthorn::ui {

// At 1280x720 a unit is a pixel; 0.6..8. Small windows keep letters of a legible size. `text_size`: what the
// user asked for, 1 is usual.
float unit_of(ivec2 window, double text_size);

// A font and its size.
struct Face {
    // The font file: in fonts/ of the installation, else in the folder `package` below
    // /usr/share/fonts/opentype. Empty: ImGui's own bitmap.
    const char* file = "";
    const char* package = "";
    float height = 21;  // units
    const char* letters =
        "";  // UTF-8: it has these alone; empty: Latin with accents, dashes, quotation marks
};

// What a program's pages look like. Colours are sRGB, 0..1; lengths are units.
struct Theme {
    Face text = {}, heading = {}, title = {};
    const char* name = "";  // set in `title` where it is a page's heading

    vec3 chosen{1, 0.8f, 0.4f};  // what is chosen, what glows
    vec3 words{0.95f};
    vec3 faint{0.7f};    // words that matter less
    vec3 behind{0.04f};  // what lies behind words

    vec2 window_padding{24, 20}, frame_padding{14, 8}, item_spacing{12, 8};
    float window_rounding = 10, frame_rounding = 8;
    float scrollbar = 12;           // its width; its corners are half as round
    float window_darkness = 0.82f;  // 0..1, of what lies behind a window's words
};

// The fonts of a theme.
struct Fonts {
    ImFont* text = nullptr;
    ImFont* heading = nullptr;
    ImFont* title = nullptr;
};

// Puts the theme's fonts for `unit` into the current ImGui context's atlas, in the place of those there are,
// and returns them; then Overlay::renew_fonts(). Where a font file is missing ImGui's own bitmap takes its
// place, and `missing` names it.
Fonts load_fonts(const Theme& theme, float unit, std::string* missing);

// Colours and spaces of the current ImGui context for `unit`.
void apply_style(const Theme& theme, float unit);

// A colour as ImGui draws it; `alpha` 0..1.
ImU32 packed(const vec3& colour, float alpha = 1);

}  // namespace lanthorn::ui
