// What the words on the picture say while playing: which things are at hand, which crystals are in sight, and
// where in the picture they are.
#pragma once

#include <string>
#include <vector>

#include "game/rules/actions.h"
#include "game/rules/components.h"
#include "lanthorn/core/math.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::game {

// "E  open the door", beside the door.
struct HudLabel {
    vec2 place{0};  // in the picture, or at its nearest edge: 0..1 from the left and from the top
    Action action = Action::use;
    std::string words;
};

// Beside a crystal, for those who cannot tell its colour.
struct HudMark {
    vec2 place{0};
    float distance = 0;  // metres from the camera
    Symbol symbol = Symbol::circle;
    float charge = 0;  // 0..1
    bool awake = false;
};

struct Hud {
    std::vector<HudLabel> labels = {};  // the nearest first
    std::vector<HudMark> marks = {};
    bool carries = false;  // a lantern,
    bool lit = false;      // that burns,
    int glasses = 0;       // with so many coloured glasses
};

// Of a world with the game's components, as the player's camera (View::camera) sees it in a picture of
// `aspect` = width / height. Crystals beside the picture or hidden by
// walls have no mark. Cost: a
// ray a crystal.
Hud look_about(const ecs::World& world, float aspect);

}  // namespace lanthorn::game
