// `emc` as Yao et al. 2010 published it needs images alone: no program that links it so has Embree.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "lanthorn/core/settings.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "tests/gpu/gi/test_scene.h"
#include "tests/support/closed_forms.h"

namespace lanthorn::gi::test {
namespace {

constexpr ivec2 kSize(48);
constexpr float kAlbedo = 0.6f;

GiSettings as_published() {
    SettingsSchema schema;
    declare_settings(schema);
    Settings settings(schema);
    settings.apply_preset(kPaperPreset);
    return gi_settings(settings);
}

std::string loaded_libraries() {
    std::ifstream maps("/proc/self/maps");
    return {std::istreambuf_iterator<char>(maps), {}};
}

TEST(PaperWithoutEmbree, SplatsPhotonsThatFlyThroughMaps) {
    Bench bench;
    bench.settings = as_published();
    const FrameScene scene = closed_sphere(kAlbedo);
    const double expected = support::sphere_irradiance(kSphereLux, 1, kAlbedo, bench.settings.bounces);
    const Deviation d = deviation_of(bench.frame(scene, kSize), expected);
    std::printf("emc as published, closed sphere: flux %.3f, relRMSE %.3f\n", d.mean, d.rel_rmse);
    // Five steps of the false position do not reach every wall from one map that is off the middle.
    EXPECT_GT(d.mean, 0.6);
    EXPECT_LT(d.mean, 1.02);
    EXPECT_LT(d.rel_rmse, 0.42);
    const GiStatistics statistics = bench.technique().statistics(true);
    EXPECT_EQ(statistics.nan_count, 0u);
    for (const char* pass : {"emission", "bounces", "splats"}) {
        EXPECT_TRUE(statistics.plan.on(pass)) << pass;
    }
    EXPECT_FALSE(statistics.plan.on("gather"));
    EXPECT_EQ(loaded_libraries().find("libembree"), std::string::npos);
}

}  // namespace
}  // namespace lanthorn::gi::test
