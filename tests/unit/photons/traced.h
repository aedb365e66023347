// Photons of a scene, and what of their flux arrives.
#pragma once

#include <cmath>

#include "gi_module/shared/photons/photon_scene.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {

struct Traced {
    PhotonScene scene;
    PhotonRun run;
    std::vector<std::uint64_t> paths;  // by group

    Traced(const FrameScene& frame, std::uint64_t count, const PhotonSettings& settings = {},
           int threads = 2) {
        scene.follow(frame, settings.scattering);
        reference::TileWorkers workers(threads);
        run = scene.tracer(settings).trace(0, count, workers);
        paths = scene.sources().paths(count);
    }
    // Lumen of the photons that `wanted` holds for.
    template <class Wanted>
    dvec3 flux(const Wanted& wanted) const {
        dvec3 sum(0);
        for (const Photon& p : run.photons) {
            if (wanted(p)) {
                sum += dvec3(p.flux) / static_cast<double>(paths[p.group]);
            }
        }
        return sum;
    }
    dvec3 after(int bounces) const {
        return flux([&](const Photon& p) { return p.bounces == bounces; });
    }
};

// A floor 2 x 2 about 0 that faces up.
inline Mesh floor_quad(std::uint32_t material, float y = 0) {
    return support::quad(vec3(-1, y, -1), vec3(0, 0, 2), vec3(2, 0, 0), material);
}

}  // namespace lanthorn::gi::test
