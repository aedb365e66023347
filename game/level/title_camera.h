// A level as the title shows it.
#pragma once

#include "lanthorn/runtime/shown_scene.h"

namespace lanthorn::game {

// Instead of the player's eyes the level's node "camera", or without one the eyes, looking about a little;
// `seconds` since it began. Call before a frame.
void look_from_title(ShownScene& level, double seconds);
void look_with_eyes(ShownScene& level);

}  // namespace lanthorn::game
