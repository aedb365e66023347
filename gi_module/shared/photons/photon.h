// A photon where it has met a surface: a vertex of a random walk from a light (Lavignotte and Paulin 2003,
// sec. 2.1).
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

struct Photon {
    vec3 position{0};             // render space, on the triangle
    std::uint32_t instance = 0;   // into FrameScene::instances
    vec3 direction{0};            // unit, the way that the light went
    std::uint32_t primitive = 0;  // triangle of the instance's mesh
    // Lumen, rgb, as if its group of lights had sent this one alone: to be divided by the number of the
    // group's paths (PhotonSources::paths()).
    vec3 flux{0};
    std::uint16_t group = 0;    // of lights, into PhotonSources::groups()
    std::uint8_t bounces = 0;   // reflections on the way here; boundaries of volumes are none
    bool front : 1 = true;      // it met the triangle's front
    bool bent : 1 = false;      // by the boundary of a volume
    bool straight : 1 = false;  // it came through a thin wall
    bool sky : 1 = false;       // the sky has sent it
    bool caustic : 1 = false;   // on its way were mirrors and glass, and nothing else
    bool diffuse : 1 = true;    // the surface scatters some light diffusely
    vec3 normal{0};             // of the triangle itself, unit, on the side that the light came from
    std::uint32_t path = 0;     // its walk's number, low 32 bits

    // Whether it is indirect light, as `path` has it: all but what comes straight from a lamp. What comes
    // through thin glass is, since direct light stops there.
    bool indirect() const { return bounces > 0 || bent || straight || sky; }
};
static_assert(sizeof(Photon) == 64);

// What a range of walks has left.
struct PhotonRun {
    std::vector<Photon> photons;  // in order of walks, then of their vertices
    std::uint64_t rays = 0;       // that it took
    std::uint64_t bad = 0;        // photons whose flux was not a number: left out
};

}  // namespace lanthorn::gi
