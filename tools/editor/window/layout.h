// Where the editor's panels lie in its window. No docking: four regions between splitters that are dragged.
#pragma once

#include "lanthorn/core/math.h"

namespace lanthorn::edit_window {

// Pixels, from the upper left.
struct Box {
    float x = 0, y = 0, width = 0, height = 0;

    bool contains(const vec2& p) const { return p.x >= x && p.y >= y && p.x < x + width && p.y < y + height; }
    bool empty() const { return !(width > 0) || !(height > 0); }
    bool operator==(const Box&) const = default;
};

// What the splitters say, in units of the text's scale; a double click on one brings these back.
struct Splits {
    float left = 248;     // width of the scene tree
    float right = 288;    // of the inspector
    float drawer = 156;   // height of the drawer, its tabs included
    float history = 156;  // height of the history under the scene tree
    bool drawer_open = true;
    bool only_picture = false;  // all but picture and status bar hidden
};

inline constexpr float kToolbar = 28, kStatus = 22, kTabs = 22, kSplitter = 4;  // units
inline constexpr float kNarrowPanel = 264;                                      // the one side panel
inline constexpr float kNarrowBelow = 1100, kLowBelow = 600;                    // units of the window

struct Layout {
    bool narrow = false;  // one side panel with tabs, in `right`; `left` and `history` are empty
    bool low = false;     // the drawer opens over the picture's lower part and is closed at first
    Box toolbar, left, history, picture, drawer, right, status;
    // Between the panels: empty where there is none.
    Box left_splitter, right_splitter, drawer_splitter, history_splitter;
};

// `unit`: pixels, of the text's scale. The regions cover the window without gaps; the picture keeps at least
// 160 by 90 units where the window has them.
Layout lay_out(ivec2 window, float unit, const Splits& splits);

}  // namespace lanthorn::edit_window
