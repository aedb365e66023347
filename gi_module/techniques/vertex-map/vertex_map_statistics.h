// What `vertex-map` counts in a frame: a part of its GiStatistics.
#pragma once

#include <cstdint>

namespace lanthorn::gi {

struct VertexMapStatistics {
    std::uint64_t photons = 0;      // shot in this frame
    std::uint64_t rays = 0;         // that they took
    std::uint64_t left = 0;         // that are old still
    std::uint64_t stored = 0;       // hits in the tree
    std::uint64_t corners = 0;      // of all meshes
    std::uint64_t triangles = 0;    // that light is interpolated over
    std::uint64_t seen = 0;         // of them: those that get light
    std::uint64_t estimates = 0;    // made in this frame
    std::uint64_t mirror_rays = 0;  // of pixels that mirror or are looked through, in this frame
    std::uint64_t builds = 0;       // of the whole acceleration structure so far
    double shoot_ms = 0, balance_ms = 0,
           estimate_ms = 0;  // the thesis's three stages, of the processor's clock
};

}  // namespace lanthorn::gi
