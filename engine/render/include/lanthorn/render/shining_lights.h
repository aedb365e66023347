// The lights that shading adds up, in the order in which its loops take them (direct.glsl): by kind, since a
// loop that knows the kind of its lights leaves out what the others need, and without those that are out.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lanthorn/render/light_data.h"

namespace lanthorn::render {

// `other`: punctual lights with neither one layer nor a cube of six, as theirs have: wide spots, and lights
// without a map.
enum class LightKind { directional, point, spot, other, area };
constexpr std::size_t kLightKinds = 5;

struct ShiningLights {
    std::vector<LightData> lights;
    // By kind: the index behind its last light. The next kind's begin there.
    std::array<int, kLightKinds> ends{};
    // Trees of those of them that are many (lamp_tree.h), kLampNodeTexels each node, and by kind the node
    // behind the last one of its tree. Empty where shading takes every light.
    std::vector<vec4> nodes;
    std::array<int, kLightKinds> node_ends{};
    // Largest radius of a group of lamps that shading takes for one, over its distance.
    float closeness = 0;

    bool has(LightKind kind) const;  // at least one of that kind is in `lights`
};

// Of each kind those that shine, in the order of `lights`; of a kind that is all out the first, so that a
// light that goes out and comes back changes no program. O(n).
ShiningLights shining_lights(std::span<const LightData> lights);

}  // namespace lanthorn::render
