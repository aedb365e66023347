// What the words on the picture say while playing: which things are at hand, where in the picture they are.
#pragma once

#include <string>
#include <vector>

#include "game/player_input.h"
#include "lanthorn/core/math.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::game {

// "E  open the door", beside the door.
struct HudLabel {
    vec2 place{0};  // in the picture: 0..1 from the left and from the top
    Button button = kUse;
    std::string words;
};

struct Hud {
    std::vector<HudLabel> labels;  // the nearest first
};

// Of a world with the game's components, as the player's camera (View::camera) sees it in a picture of
// `aspect` = width / height. Things behind her or beside the picture have no label.
Hud look_about(const ecs::World& world, float aspect);

}  // namespace lanthorn::game
