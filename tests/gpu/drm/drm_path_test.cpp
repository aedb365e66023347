// `drm` beside the path tracer, one bounce each. What is left of the difference is what the technique leaves
// out: shadows of indirect light.
#include <gtest/gtest.h>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"
#include "tests/gpu/drm/drm_bench.h"
#include "tests/gpu/gi/path_truth.h"
#include "tests/support/repository.h"

namespace lanthorn::gi::test {
namespace drm_path_test {

constexpr ivec2 kSize(96);

FrameScene scene_in(const char* file) {
    ecs::World world;
    spawn(world, import_gltf(support::repository_file(file)));
    Transforms().update(world);
    return Extractor().extract(world, find_by_name(world, "camera"));
}

Deviation of(const FrameScene& scene, const Truth& truth, SolidAngle kind, int side) {
    DrmBench bench;
    bench.drm().solid_angle = kind;
    bench.drm().samples = side;
    const Deviation d = against(bench.frame(scene, kSize), truth);
    std::printf("drm, M = %d, solid angle %d: flux %.3f, relRMSE %.3f\n", side, static_cast<int>(kind),
                d.mean, d.rel_rmse);
    return d;
}

TEST(DrmPath, CornellsOneBounce) {
    const FrameScene scene = scene_in("assets/cornell.glb");
    const Truth truth = path_traced(scene, kSize, 1, 256);
    const Deviation eq14 = of(scene, truth, SolidAngle::eq_14, 3),
                    disc = of(scene, truth, SolidAngle::disc, 3),
                    eq15 = of(scene, truth, SolidAngle::eq_15, 3),
                    eq11 = of(scene, truth, SolidAngle::eq_11, 3);
    // The paper's order of its three, and that a disc's own solid angle keeps more of the light.
    EXPECT_LT(eq14.rel_rmse, eq15.rel_rmse);
    EXPECT_LT(eq15.rel_rmse, eq11.rel_rmse);
    EXPECT_LT(std::abs(disc.mean - 1), std::abs(eq14.mean - 1));
    EXPECT_NEAR(disc.rel_rmse / eq14.rel_rmse, 1, 0.1);
    const Deviation many = of(scene, truth, SolidAngle::disc, 16);
    EXPECT_NEAR(many.mean, 1, 0.25);
}

// Fig. 7: what is close to the lamp is small and bright, and eq. 11 takes it for as wide as a wall.
TEST(DrmPath, ABallNearTheLampOverexposesEq11) {
    const FrameScene scene = scene_in("assets/near-lamp.glb");
    const Truth truth = path_traced(scene, kSize, 1, 256);
    const Deviation eq14 = of(scene, truth, SolidAngle::eq_14, 3),
                    disc = of(scene, truth, SolidAngle::disc, 3),
                    eq15 = of(scene, truth, SolidAngle::eq_15, 3),
                    eq11 = of(scene, truth, SolidAngle::eq_11, 3),
                    eq13 = of(scene, truth, SolidAngle::eq_13, 3);
    EXPECT_LT(eq14.rel_rmse, 0.7 * eq15.rel_rmse);
    EXPECT_LT(eq15.rel_rmse, 0.1 * eq11.rel_rmse);
    EXPECT_LT(disc.rel_rmse, eq14.rel_rmse);
    EXPECT_GT(eq11.mean, 10);
    EXPECT_LT(eq15.mean, 1) << "areas shrink as things come near: it does not overexpose";
    EXPECT_GT(eq13.mean, eq14.mean) << "the bound takes light away";
}

// No block, no shadow of indirect light: all that is left is the samples'.
TEST(DrmPath, AnEmptyRoomsOneBounce) {
    FrameScene scene =
        scene_of({box(vec3(0), vec3(4, 2.6f, 3), true, 0)}, {lambertian(vec3(0.6f))},
                 {point_light(vec3(0.9f, 1.7f, 1.5f), 100)}, vec3(3.7f, 1.5f, 2.8f), vec3(1, 1, 1));
    const Truth truth = path_traced(scene, kSize, 1, 256);
    const Deviation few = of(scene, truth, SolidAngle::disc, 3),
                    many = of(scene, truth, SolidAngle::disc, 16);
    EXPECT_NEAR(many.mean, 1, 0.05);
    EXPECT_LT(many.rel_rmse, 0.12);
    EXPECT_LT(many.rel_rmse, few.rel_rmse);
}

}  // namespace drm_path_test
}  // namespace lanthorn::gi::test
