// The project's own scenes. Each is written to assets/NAME.glb by `generate_scenes assets`.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene_data.h"

namespace lanthorn::scene_generator {

SceneData cornell();         // the measured Cornell box
SceneData two_rooms();       // two furnished rooms, one lit, joined by a doorway
SceneData clutter();         // forty floating boxes in a closed room
SceneData lantern_room();    // the first room of the game
SceneData puppet();          // a skinned figure walks through a coloured room with a lantern
SceneData furnace_sphere();  // a sphere lit from its centre: the answer is known in closed form

struct NamedScene {
    std::string name;
    SceneData (*make)();
};
const std::vector<NamedScene>& all_scenes();

}  // namespace lanthorn::scene_generator
