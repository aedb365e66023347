// What area samples stand for, in ever smaller parts, for surfaces that are near. Read by near_emitters.glsl.
#pragma once

#include <vector>

#include "engine/render/emissive_parts.h"
#include "lanthorn/render/light_data.h"

namespace lanthorn::render {

// Appends the sample's faces to `nodes` as a binary tree, in the order of a walk that goes to a node's
// children first, and writes into `light` which nodes those are (cone_scale: the first, cone_offset: the one
// behind the last), the middle of all (up) and how far from it they reach (depth_range). A node is
// kEmitterNodeTexels:
//   middle, radius | a, the node behind it and all below | b, sine of how far normals are off the mean | nits
// A face has the corners middle + a, middle + b, middle - a - b. What stands for several has their area along
// their mean normal. `most` faces at most have nodes of their own. O(n log n).
void add_near_emitter(const EmissiveSample& sample, std::size_t most, LightData& light,
                      std::vector<vec4>& nodes);

}  // namespace lanthorn::render
