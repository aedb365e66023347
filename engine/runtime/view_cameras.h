// Where views look from.
#pragma once

#include <optional>

#include "lanthorn/ecs/world.h"
#include "lanthorn/runtime/view.h"

namespace lanthorn {

// Throws Error that names the first view to be drawn whose camera has been destroyed or has no
// CameraComponent or WorldTransform.
void check_cameras(const ecs::World& world);

// The view's camera if it is one; else the null entity.
ecs::Entity camera_entity(const ecs::World& world, const View& view);

// The camera of `view` as it stands in the world, in the render space of `origin`; none: the one that sees
// everything, also where the camera's transform is not finite or the camera is not there.
std::optional<CameraView> look_of(const ecs::World& world, const View& view, const dvec3& origin);

}  // namespace lanthorn
