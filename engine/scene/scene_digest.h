// What tells two loaded scenes apart.
#pragma once

#include <array>
#include <cstdint>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// 128 bits of everything in `scene` but its source and warnings (XXH3). O(data).
using SceneDigest = std::array<std::uint64_t, 2>;
SceneDigest scene_digest(const SceneData& scene);

}  // namespace lanthorn
