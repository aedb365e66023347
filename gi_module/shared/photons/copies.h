// Triangles that lie exactly in each other's place, as exporters leave them when something is doubled: light
// falls on one of them and the picture shows another. For whoever asks which surface a photon lies on, they
// are one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// By instance: the first one with the same triangles in the same places, facing the same way; itself where
// there is none before it. O(instances log instances), and O(vertices) of those of one size in one place.
std::vector<std::uint32_t> first_of_copies(const FrameScene& scene);

// By triangle of a mesh: the first one with the same corners in the same order, whichever is named first;
// itself where there is none before it. `places`: of vertices, the same number for the same place. O(n log
// n).
std::vector<std::uint32_t> first_of_copies(std::span<const std::uint32_t> indices,
                                           std::span<const std::uint32_t> places);

// The same number for vertices in the same place: that of one of them. O(n log n).
std::vector<std::uint32_t> vertex_places(std::span<const vec3> positions);

}  // namespace lanthorn::gi
