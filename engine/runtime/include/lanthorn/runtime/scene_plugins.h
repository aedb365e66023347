// The plugins that every App with a scene has, and what is asked of a scene that is only looked at.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/scene/extras.h"
#include "lanthorn/scene/frame_scene.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// ScenePlugin, AnimationPlugin, PhysicsPlugin, DeformationPlugin: no OpenGL.
void add_scene_plugins(App& app);

// spawn(), and the components that the nodes' extras name, as the App's plugins have declared them. Throws as
// apply_extras() where `bad` is to be refused.
std::vector<ecs::Entity> spawn_scene(App& app, SceneData scene, BadExtras bad = BadExtras::refuse);

// The clip that a node's `start_clip` names; "none": it wants none; empty: no node has one. O(nodes).
std::string named_clip(ecs::World& world);

// Plays a clip of the scenes that have been spawned, by the App's clock: what is shown at a moment is the
// clip's pose at that moment, looped. `animation` is a clip's name, its number, "none", or empty for the
// named_clip(), and without one each scene's first. Throws InputError naming `source` and the clips that
// there are if no scene has it.
void play_clip(ecs::World& world, const std::string& animation, const std::string& source);

// The world as it stands, without history: at full detail, with an origin that no frame before has chosen.
// For what looks at a scene once: path tracers, hashes, reports. Writes WorldTransform and DeformedMeshes.
FrameScene still_scene(ecs::World& world, ecs::Entity camera = ecs::kNullEntity);

}  // namespace lanthorn
