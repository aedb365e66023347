// What differs between two snapshots of a scene.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

// As of a first snapshot: all of it came. O(instances + slots of assets).
SceneChanges all_changed(const FrameScene& now);

// By instance of `now`: the index that the same one has in `before`; kNone: it was not there. O(instances).
std::vector<std::uint32_t> earlier_instances(std::span<const Instance> before, std::span<const Instance> now);

// What differs in `now`; of `before` all counts but deformed vertices, sensors and bounds. `earlier`: of
// earlier_instances(). O(instances, and slots of assets where any differs).
SceneChanges changes_between(const FrameScene& before, const FrameScene& now,
                             std::span<const std::uint32_t> earlier);

}  // namespace lanthorn
