// A box put into a scene.
#pragma once

#include <string>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::workbench {

// Adds a node of that name with an upright cube about `centre`, `side` metres long: matte, Lambertian, of
// that reflectance.
void place_grey_box(SceneData& scene, const std::string& name, const dvec3& centre, float side,
                    float reflectance);

}  // namespace lanthorn::workbench
