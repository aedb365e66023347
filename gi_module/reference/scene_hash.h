// A number that two FrameScenes share only if the same light would be seen in them.
#pragma once

#include <cstdint>

#include "lanthorn/reference/path_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::reference {

// Geometry, materials, textures, lights and camera; names and what changed do not count. O(bytes).
std::uint64_t scene_hash(const FrameScene& scene);

// The same with everything else that samples depend on: image size, seed, bounces, transport.
std::uint64_t sample_hash(const FrameScene& scene, ivec2 size, const PathSettings& settings);

}  // namespace lanthorn::reference
