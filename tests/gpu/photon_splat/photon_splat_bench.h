// `splat` in an App.
#pragma once

#include "lanthorn/photon_splat/photon_splat_technique.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

inline constexpr ivec2 kSize(96);

// A Bench of this technique; tells the door of it first. As many photons at once as it ever has.
struct Splat : Bench {
    explicit Splat(int photons = 100'000) : Bench(add_photon_splat()) {
        settings.photons = photons;
        own().photons = 0;
    }
    PhotonSplatSettings& own() { return settings.edit<PhotonSplatSettings>(); }
    PhotonSplatStatistics now() { return technique().statistics(false).of<PhotonSplatStatistics>(); }
};

}  // namespace lanthorn::gi::test
