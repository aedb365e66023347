// Ladders that need not know what light is made of, and the pixels that every ladder ends with.
#pragma once

#include <string>

#include "lanthorn/runtime/budget_control.h"

namespace lanthorn {

// Smaller pictures, then lower presets from `best` down, then smaller pictures yet. One group: all passes.
BudgetLadder ladder_of_presets(const std::string& best);

// Adds rungs with ever smaller pictures. `pixels`: the group of passes that shrinks with the picture.
void add_smaller_pictures(BudgetLadder& ladder, std::size_t pixels);

}  // namespace lanthorn
