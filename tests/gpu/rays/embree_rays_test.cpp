// gi.emc.rays = bvh and fastest: rays that meet triangles, looked up in the lit maps.
#include "gi_module/shared/rays/embree_rays.h"

#include <gtest/gtest.h>

#include "gi_module/shared/rays/exact_rays.h"
#include "lanthorn/emc/emc_settings.h"
#include "tests/gpu/gi/test_scene.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace {

TEST(EmbreeRays, MeetWhatIsThere) {
    add_embree_rays();
    const std::unique_ptr<ExactRays> rays = make_exact_rays();
    ASSERT_TRUE(rays);
    const FrameScene room = scene_of({box(vec3(0), vec3(4, 3, 2), true, 0)}, {lambertian(vec3(0.5f))}, {},
                                     vec3(1), vec3(2, 1, 1));
    rays->follow(room, RayDetail::full);
    const std::vector<ExactRay> asked = {{vec3(1, 1, 1), 0, vec3(1, 0, 0), 0},
                                         {vec3(1, 1, 1), 0, vec3(0, -1, 0), 0},
                                         {vec3(9, 9, 9), 0, vec3(0, 1, 0), 0}};
    std::vector<Arrival> arrivals(asked.size());
    rays->trace(asked, arrivals, true);
    EXPECT_FLOAT_EQ(arrivals[0].distance, 3);
    EXPECT_FLOAT_EQ(arrivals[1].distance, 1);
    EXPECT_EQ(arrivals[2].distance, 0);
    // Octahedral: -x is (-1, 0), +y is (0, 1).
    EXPECT_EQ(glm::unpackSnorm2x16(arrivals[0].normal), vec2(-1, 0));
    EXPECT_EQ(glm::unpackSnorm2x16(arrivals[1].normal), vec2(0, 1));
    EXPECT_EQ(arrivals[0].albedo, 0x808080u);
    EXPECT_EQ(arrivals[2].albedo, 0u);
    rays->trace(asked, arrivals, false);
    EXPECT_EQ(arrivals[0].albedo, 0u);
}

ImageF gathered(EmcRays rays, bool& exact) {
    Bench bench;
    bench.settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
    bench.settings.edit<EmcSettings>().rays = rays;
    bench.settings.edit<EmcSettings>().gather_endless = false;
    const ImageF image = bench.frame(closed_sphere(0.9f), ivec2(64));
    for (const PlanEntry& entry : bench.technique().statistics(false).plan.entries) {
        exact =
            exact || (entry.pass == "gather" && entry.size.find("through triangles") != std::string::npos);
    }
    return image;
}

TEST(EmbreeRays, GatherTheSeriesInAClosedSphere) {
    add_embree_rays();
    bool exact = false;
    const ImageF image = gathered(EmcRays::bvh, exact);
    EXPECT_TRUE(exact);
    const Deviation off = deviation_of(image, support::sphere_irradiance(kSphereLux, 1, 0.9, 2));
    EXPECT_NEAR(off.mean, 1, 0.01);
    EXPECT_LT(off.rel_rmse, 0.015);
}

// Which one it is depends on the machine; the picture is that one's, and the plan says so.
TEST(EmbreeRays, TheFastestIsOneOfBoth) {
    add_embree_rays();
    bool exact = false;
    const ImageF fastest = gathered(EmcRays::fastest, exact);
    bool same = exact;
    const ImageF chosen = gathered(exact ? EmcRays::bvh : EmcRays::maps, same);
    EXPECT_EQ(same, exact);
    EXPECT_EQ(fastest.pixels, chosen.pixels);
}

// While it is dark nothing is followed; rays must not meet a block where it was before.
TEST(EmbreeRays, MeetWhatMovedInTheDarkWhereItIs) {
    add_embree_rays();
    const auto room = [](float candela) {
        return scene_of(
            {box(vec3(0), vec3(4, 2.6f, 3), true, 0), box(vec3(1.5f, 0, 1), vec3(2.5f, 1.6f, 2), false, 0)},
            {lambertian(vec3(0.6f))}, {point_light(vec3(0.6f, 2.2f, 1.5f), candela)}, vec3(3.7f, 1.5f, 2.8f),
            vec3(1, 1, 1));
    };
    const auto move_away = [](FrameScene& scene) {
        move_instance(scene, 1, glm::translate(mat4(1), vec3(0, 0, 5)));
    };
    Bench bench, fresh;
    for (Bench* b : {&bench, &fresh}) {
        b->settings.edit<EmcSettings>().final_stage = EmcFinal::gather;
        b->settings.edit<EmcSettings>().rays = EmcRays::bvh;
    }
    bench.frame(room(100), ivec2(64));
    FrameScene scene = room(0);
    hold_still(scene);
    scene.changes.lights = true;
    move_away(scene);
    bench.frame(scene, ivec2(64));
    hold_still(scene);
    scene.lights = room(100).lights;
    scene.changes.lights = true;
    const ImageF image = bench.frame(scene, ivec2(64));
    FrameScene anew = room(100);
    move_away(anew);
    EXPECT_EQ(image.pixels, fresh.frame(anew, ivec2(64)).pixels);
}

}  // namespace
}  // namespace lanthorn::gi::test
