// Playing what was imported.
#pragma once

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// Plays every clip and looks at every vertex: expects finite numbers and rotations of length 1.
void expect_plays(SceneData scene);

}  // namespace lanthorn
