// Hits that a lit texel is too wide for, where more of them want a place of their own than there are.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <optional>

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

void look_closely_at_hits(Bench& bench) {
    add_embree_rays();
    EmcSettings& emc = bench.settings.edit<EmcSettings>();
    emc.final_stage = EmcFinal::gather;
    emc.rays = EmcRays::bvh;
    emc.gather_texels = 16;
    emc.gather_grid = 1;
    emc.gather_rays = 8;
}

ImageF pictured() {
    Bench bench;
    look_closely_at_hits(bench);
    return still_picture(bench, blocks_around_a_lamp(), 4, ivec2(128));
}

TEST(CloseHits, RepeatBitForBitWherePlacesAreTooFew) {
    const ImageF first = pictured();
    for (int run = 0; run < 2; ++run) {
        EXPECT_EQ(pictured().pixels, first.pixels) << "run " << run;
    }
}

// Which slot a hit has says nothing: it hangs on which had it before, and on which thread came first. Lit
// maps keep two kinds of light apart: that of one reflection of lamps, and all. Here a sky comes and goes,
// and what blocks that move reflected in the frame before guides the next rays. `before`: where the camera is
// in frames whose rays are all forgotten then. The picture is so small that there are slots for all.
ImageF pictured_under_a_sky_that_comes_and_goes(const vec3& before) {
    Bench bench;
    look_closely_at_hits(bench);
    bench.settings.bounces = 1;
    EmcSettings& emc = bench.settings.edit<EmcSettings>();
    emc.gather_source = GatherSource::rays;  // by photons rays are forgotten when a sky comes
    emc.gather_endless = false;
    emc.reserved = 0;
    emc.gather_rays = 4;
    SkyInstance sky;
    sky.sky.image = std::make_shared<const SkyImage>(SkyImage{"", 2, 1, {vec3(1), vec3(1)}});
    FrameScene scene = blocks_around_a_lamp();
    const CameraView camera = scene.camera;
    support::look(scene, before, vec3(0));
    for (int frame = -2; frame < 6; ++frame) {
        if (frame == 0) {
            emc.gather_rays = 8;
            scene.camera = camera;
            scene.changes.camera = true;
        }
        if (frame == 0 || frame == 2 || frame == 4) {
            scene.sky = frame == 2 ? std::nullopt : std::optional(sky);
            scene.changes.lights = true;
        }
        for (std::uint32_t i = 1; i < scene.instances.size() && frame > 0; ++i) {
            move_instance(scene, i, glm::translate(mat4(1), vec3(0, 0.02f * static_cast<float>(frame), 0)));
        }
        bench.show(scene, ivec2(24));
        hold_still(scene);
    }
    return bench.renderer().read(render::Aov::indirect);
}

TEST(CloseHits, HaveNothingOfThoseThatHadTheirSlotsBefore) {
    const ImageF first = pictured_under_a_sky_that_comes_and_goes(vec3(0.9f, 0.8f, 0.7f));
    EXPECT_GT(mean_of(first), 0);
    for (const vec3& before : {vec3(-0.9f, 0.1f, 0.3f), vec3(0.2f, -0.8f, 0.6f)}) {
        EXPECT_EQ(pictured_under_a_sky_that_comes_and_goes(before).pixels, first.pixels);
    }
}

}  // namespace
}  // namespace lanthorn::gi::test
