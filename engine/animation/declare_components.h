// The components of what plays (animation_player.h), declared.
#pragma once

#include "lanthorn/ecs/registry.h"

namespace lanthorn {

// Once a registry; throws ecs::Error the second time. The player is not read from extras.
void declare_animation_components(ecs::Registry& registry);

}  // namespace lanthorn
