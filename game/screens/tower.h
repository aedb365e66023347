// The tower that the game is about: a window for each room, lit once the room is solved.
#pragma once

#include "game/screens/model.h"

namespace lanthorn::game::ui {

// At the right edge of the picture, behind the page's words; nothing where the window has no room for it.
void draw_tower(const Model& model);

}  // namespace lanthorn::game::ui
