// What `emc` counts in a frame: parts of its GiStatistics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// Of the photons that diffuse surfaces reflect. Counted only where statistics() is asked to read them back.
struct PhotonStatistics {
    std::uint64_t emitted = 0;
    std::uint64_t stored = 0;        // arrivals, all bounces together
    std::uint64_t lost = 0;          // photons that no map had a hit for
    dvec3 flux_emitted{0};           // lumen
    std::vector<dvec3> flux_stored;  // lumen, by bounce (1..)
    dvec3 flux_from_sky{0};          // lumen, straight from it
};

// Of the lists of photons by tile of the screen.
struct SplatListStatistics {
    std::uint64_t entries = 0;    // of the frame before the last that sorted any
    std::uint64_t capacity = 0;   // that there is room for now
    std::uint64_t overflows = 0;  // frames whose lists there was no room for: slow, with nothing lost
};

struct EmcStatistics {
    int k = 0;         // maps in use that were selected
    int reserved = 0;  // maps beside them, for what the picture's rays have met and none of those shows
    int candidates = 0;
    int resolution = 0;
    double coverage = 0;        // area the selected maps see over the area all candidates see, by eq. 1; 0..1
    std::uint64_t updates = 0;  // progressive updates and initial selections so far
    int refinement_steps = 0;   // of the last initial selection
    std::size_t map_bytes = 0;  // GPU memory of the maps
    // Of many rooms: maps of rooms left behind.
    int kept = 0;
    std::size_t kept_bytes = 0;
    std::uint64_t brought_back = 0;  // instead of being drawn, so far
};

// Of the photons of caustics, most of which are sent towards mirrors and glass.
struct CausticStatistics {
    std::uint64_t emitted = 0;  // those that the picture is made of
    std::uint64_t traced = 0;   // of them, by the last frame that traced any
    std::uint64_t stored = 0;   // arrivals
    std::uint64_t bad_values = 0;
    dvec3 flux_stored{0};     // lumen; of those that have met mirrors and glass alone
    dvec3 flux_scattered{0};  // of the others
};

// Of gi.emc.final = gather.
struct GatherStatistics {
    std::uint64_t rays = 0;        // shot in the frame, from the picture and from the lit maps
    std::uint64_t remembered = 0;  // rays of this and earlier frames that the picture is made of
    std::uint64_t lit_texels = 0;
    // By the last survey of what the picture's rays met.
    std::uint64_t points = 0;        // of the picture, that have rays
    std::uint64_t blind_points = 0;  // of them, those a quarter of whose rays met what no lit texel shows
    double unknown_share = 0;        // of all rays, those that did; 0..1
};

}  // namespace lanthorn::gi
