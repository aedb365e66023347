// A level as the title shows it.
#pragma once

#include "lanthorn/runtime/shown_scene.h"

namespace lanthorn::game {

// The level's node "camera", or without one the player's eyes.
ecs::Entity title_camera(ShownScene& level);

// Instead of the player's eyes the title_camera(), looking about a little; `seconds` since it began. Call
// before a frame.
void look_from_title(ShownScene& level, double seconds);
void look_with_eyes(ShownScene& level);

}  // namespace lanthorn::game
