// The few things that the screens are made of. They are chosen by keys and gamepad (ImGui's navigation) as by
// mouse, and show themselves which one that is.
#pragma once

#include <functional>
#include <string>

#include "game/screens/model.h"

namespace lanthorn::game::ui {

// Darkens the picture from the left, where the words are; `reach`: to which share of the width.
void draw_shade(float reach, float darkness);

// Without a mouse what keys would choose is chosen from the beginning; ImGui waits for a first key that
// moves.
void let_keys_choose(const Model& model);

// A column of entries on the left over a shade, of all the window's height; it scrolls if it has to. The
// game's name (kName) as the heading is set larger. Small windows do without that and the room around it.
void begin_column(const Model& model, const char* id, const std::string& heading, const std::string& words);
void end_column();

// A line that is chosen. `first`: where keys start when the screen appears. Returns whether it was chosen.
bool entry(const Model& model, const char* words, bool first = false);

// A line with a value that left and right change, and choosing too: `step` is -1 or 1.
void row(const Model& model, const char* words, const std::string& value,
         const std::function<void(int)>& step, bool first = false);

void section(const Model& model, const char* words);

// Whether the player asked to go back (Esc, the menu's key or button, a gamepad's B) on this screen.
bool wants_back(const Model& model);

// Whether the item that was just added is the one that would be chosen now. Scrolls to it.
bool is_chosen(const Model& model);

}  // namespace lanthorn::game::ui
