// What a program's pages are made of: columns of entries, and rows with a value. They are chosen by keys and
// gamepad (ImGui's navigation) as by mouse, and show themselves which one that is.
//
//   state.update(number, page);                     // after Overlay::begin()
//   draw_shade(page, 0.6f, 0.9f);
//   begin_column(page, "title", "walk", "A walk in a room.");
//   if (entry(page, "Play", true)) ...
//   end_column(page);
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "lanthorn/ui/theme.h"

namespace lanthorn::ui {

// What widgets must know of the page that they are on, in this frame.
struct Page {
    const Theme* theme = nullptr;  // as load_fonts() and apply_style() have had it
    Fonts fonts;
    float unit = 1;           // pixels
    bool appearing = false;   // the page is shown for the first time
    bool pointing = false;    // the mouse was used last, not keys or gamepad
    float shown_seconds = 0;  // since the page appeared
};

// What a page has to know of the frames before: how long it has been there, and what it is used with.
class PageState {
  public:
    // Call once a frame between ImGui::NewFrame() and the page; fills in the members of `page` that change
    // from frame to frame. `number`: the program's own, of the page that is shown.
    void update(int number, Page& page);

  private:
    std::optional<int> number_;
    float seconds_ = 0;
    bool pointing_ = false;
};

// Units that a column is wide where the window is.
inline constexpr float kColumnUnits = 620;

// Darkens the picture from the left, where the words are; `reach`: to which share of the width. `darkness`:
// 0..1. `words`: units that words reach to, behind which it is as dark.
void draw_shade(const Page& page, float reach, float darkness, float words = 0);

// Unless a mouse points at something, what keys would choose is chosen from the beginning; ImGui waits for a
// first key that moves. Call before ImGui::Begin() of windows of one's own; begin_column() does it.
void let_keys_choose(const Page& page);

// A column of entries on the left, of all the window's height; it scrolls if it has to. `id`: ImGui's name of
// it. The program's name (Theme::name) as the heading is set larger; `words` stand below it. Small windows do
// without that and the room around it.
void begin_column(const Page& page, const char* id, const std::string& heading, const std::string& words);
// The end of the column: up from its first entry is its last one.
void end_column(const Page& page);

// A line that is chosen. `first`: where keys start when the page appears. Returns whether it was chosen.
bool entry(const Page& page, const char* words, bool first = false);

// A line with a value that left and right change, and choosing too: `step` is -1 or 1.
void row(const Page& page, const char* words, const std::string& value, const std::function<void(int)>& step,
         bool first = false);

// Words over the lines that follow.
void section(const Page& page, const char* words);

// Whether the user asked to go back (Esc or a gamepad's B) on this page.
bool wants_back(const Page& page);

// Whether the item that was just added is the one that would be chosen now. Scrolls to it.
bool is_chosen(const Page& page);

}  // namespace lanthorn::ui
