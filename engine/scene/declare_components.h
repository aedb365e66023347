// The components of scene nodes (components.h, light_sensor.h), declared.
#pragma once

#include "lanthorn/ecs/registry.h"

namespace lanthorn {

// Once a registry; throws ecs::Error the second time. What the file says elsewhere than in extras
// (transforms, lights, cameras, names) is not read from extras: of these components `light_sensor` alone is.
void declare_scene_components(ecs::Registry& registry);

}  // namespace lanthorn
