// Physics' components (components.h), declared.
//
//   {"body": {"type": "static" | "dynamic" | "kinematic",
//             "shape": "box" | "sphere" | "capsule" | "convex" | "mesh",
//             "mass": 1, "friction": 0.5, "restitution": 0,
//             "size": [x, y, z], "radius": 1, "height": 1, "centre": [x, y, z]}}
//   {"collider": {"shape": ..., as above without type and mass}}          or {"collider": "box"}
//   {"character": {"radius": 0.3, "height": 1.8, "stepHeight": 0.35, "slopeLimit": 0.87, "jumpSpeed": 4.5}}
#pragma once

#include "lanthorn/ecs/registry.h"

namespace lanthorn::physics {

// After declare_scene_components; once a registry, throws ecs::Error the second time. `body` (RigidBody),
// `collider` and `character` are read from extras.
void declare_physics_components(ecs::Registry& registry);

}  // namespace lanthorn::physics
