// What the stages of `vertex-map` cost in the thesis's scene: as Jozwowski 2002 has them, and as they are
// here, of the same photons.
#pragma once

#include <cstddef>

#include "gi_module/techniques/vertex-map/vertex_map_settings.h"

namespace lanthorn::bench {

struct Case {
    int side = 1;       // 16 side^2 surfaces
    int shot_side = 0;  // of the surfaces that photons meet; 0: the same
    gi::VertexMapSettings settings;
};

// Sec. 5.1: 2000 photons, 100 a frame, 3 levels of which the first is direct light, 100 in an estimate, no
// speed-ups.
Case thesis_case(int side);

// Milliseconds of the processor a frame, medians.
struct Stages {
    struct Way {
        double shoot = 0, balance = 0, estimate = 0;
        double whole() const { return shoot + balance + estimate; }
    };
    // Photons ask every surface, one tree is rebuilt, and whatever lies near by counts over the whole circle.
    Way thesis;
    // Photons ask a tree (Embree), each surface has a tree of photons, which is kept, and photons of the
    // point's own surface count over what of the circle is surface.
    Way here;
    double rebuilt = 0;         // balancing: the trees of `here`, rebuilt
    std::size_t estimates = 0;  // of a frame
    std::size_t stored = 0;     // photons
    double agree = 0;           // share of rays that meet the same surface when all are asked
};

// One thread; the light moves in each of the frames.
Stages measure(const Case& c, int frames);

}  // namespace lanthorn::bench
