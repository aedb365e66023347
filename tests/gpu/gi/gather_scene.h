// What the tests of the final gather share: its settings, a room, and a picture in which nothing changes.
#pragma once

#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

// By rays, at each pixel of its grid, so many bounces and no more: what closed forms and the path tracer say
// of it. (By photons: lit_photons_test.cpp.)
inline GiSettings gathered_by_rays(int bounces = 2) {
    GiSettings settings;
    settings.bounces = bounces;
    EmcSettings& emc = settings.edit<EmcSettings>();
    emc.final_stage = EmcFinal::gather;
    emc.gather_source = GatherSource::rays;
    emc.gather_points = 1;
    emc.gather_endless = false;
    return settings;
}

// After `frames` frames in which nothing changes.
inline ImageF still_picture(Bench& bench, FrameScene scene, int frames, ivec2 size) {
    ImageF image = bench.frame(scene, size);
    hold_still(scene);
    for (int f = 1; f < frames; ++f) {
        image = bench.frame(scene, size);
    }
    return image;
}

// Two lamps (candela) in a room of one grey, with a block: light that varies, and shadows.
inline FrameScene room_with_block(float first = 100, float second = 60) {
    return scene_of(
        {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(1.6f, 0, 0.7f), vec3(2.4f, 1.2f, 2.3f), false, 1)},
        {lambertian(vec3(0.6f)), lambertian(vec3(0.7f, 0.3f, 0.2f))},
        {point_light(vec3(0.6f, 2.2f, 1.5f), first), point_light(vec3(3.5f, 0.6f, 0.4f), second)},
        vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
}

}  // namespace lanthorn::gi::test
