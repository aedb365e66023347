// `splat` in an App.
#pragma once

#include "gi_module/techniques/splat/splat_technique.h"
#include "lanthorn/splat/splat.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

inline constexpr ivec2 kSize(96);

// A Bench of this technique; tells the door of it first. As many photons at once as it ever has.
struct Splat : Bench {
    explicit Splat(int photons = 100'000) : Bench(add_splat()) {
        settings.photons = photons;
        own().photons = 0;
    }
    SplatSettings& own() { return settings.edit<SplatSettings>(); }
    SplatStatistics now() { return technique().statistics(false).of<SplatStatistics>(); }
};

}  // namespace lanthorn::gi::test
