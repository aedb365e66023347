// Hits that a lit texel is too wide for, where more of them want a place of their own than there are.
#include <gtest/gtest.h>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/gather_scene.h"

namespace lanthorn::gi::test {
namespace {

// A lamp between many small blocks, in lit texels of a hand's width: nearly each ray meets one beside the
// lamp.
FrameScene blocks_around_a_lamp() {
    std::vector<Mesh> meshes{box(vec3(-1), vec3(1), true, 0)};
    for (int i = 0; i < 27; ++i) {
        const vec3 middle = 0.5f * (vec3(i % 3, i / 3 % 3, i / 9) - 1.0f);
        if (i != 13) {
            meshes.push_back(box(middle - 0.06f, middle + 0.06f, false, 0));
        }
    }
    return scene_of(std::move(meshes), {lambertian(vec3(0.6f))}, {point_light(vec3(0, 0.1f, 0), 100)},
                    vec3(0.9f, 0.8f, 0.7f), vec3(0));
}

ImageF pictured() {
    add_embree_rays();
    Bench bench;
    EmcSettings& emc = bench.settings.edit<EmcSettings>();
    emc.final_stage = EmcFinal::gather;
    emc.rays = EmcRays::bvh;
    emc.gather_texels = 16;
    emc.gather_grid = 1;
    emc.gather_rays = 8;
    return still_picture(bench, blocks_around_a_lamp(), 4, ivec2(128));
}

TEST(CloseHits, RepeatBitForBitWherePlacesAreTooFew) {
    const ImageF first = pictured();
    for (int run = 0; run < 2; ++run) {
        EXPECT_EQ(pictured().pixels, first.pixels) << "run " << run;
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
