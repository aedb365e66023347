// What a point of the chart may show: techniques that remember, with their memory.
#include <gtest/gtest.h>

#include <cmath>

#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/trade_measure.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"
#include "tools/lanthorn/common/child_process.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {
namespace trade_memory_test {

constexpr ivec2 kPixels(48);

class TradeMemory : public testing::Test {
  protected:
    TradeMemory() { declare_all_settings(schema_); }

    std::string trace(const std::string& name, const std::string& aov) const {
        std::string file = folder_.path(name);
        const ChildOutcome outcome = run_child({LANTHORN_BINARY, "render", kScene, "-o", file, "--technique",
                                                "path", "--aov", aov, "--size", "48x48", "--spp", "256",
                                                "--seed", "7001", "--set", "path.transport=diffuse"});
        EXPECT_TRUE(outcome.ok()) << outcome.why();
        return file;
    }
    // relRMSE of the frame after `warmup` others.
    double error_after(int warmup, const TradeReferences& references) const {
        const TradePoint point{kScene,
                               "emc",
                               "medium",
                               {"gi.emc.final=gather", "gi.emc.candidates=8", "gi.emc.resolution=64"},
                               {}};
        TradeView view = view_point(point, {kPixels, {}, 1, warmup}, schema_);
        compare_with_references(view, references);
        return view.figures.relrmse;
    }

    inline static const std::string kScene = support::repository_file("assets/cornell.glb");
    SettingsSchema schema_;
    testing_tools::TemporaryFolder folder_;
};

// A scene whose only lamp is a mesh, which stands: its light is all that may change. Measured 0.65; without
// memory both frames are the same.
TEST_F(TradeMemory, HitsAreRememberedWhileLightChanges) {
    const std::string indirect = trace("indirect.exr", "indirect");
    const TradeReferences references = {indirect, indirect, trace("final.exr", "final")};
    const double first = error_after(0, references), seventeenth = error_after(16, references);
    EXPECT_LT(seventeenth, 0.8 * first) << first;
}

// Both end where the scene has everything, so that the same references serve them.
TEST_F(TradeMemory, ACameraThatWalksEndsWhereTheSceneHasIt) {
    TradePoint point{
        kScene, "emc", "low", {"gi.emc.final=splat", "gi.photons=4000", "gi.emc.candidates=8"}, {}};
    const TradeMeasurement job{kPixels, {}, 2, 2};
    const TradeView stands = view_point(point, job, schema_);
    point.motion = TradeMotion::walk;
    const TradeView walks = view_point(point, job, schema_);
    ASSERT_EQ(walks.final.pixels.size(), stands.final.pixels.size());
    double off = 0, sum = 0;
    for (std::size_t i = 0; i < walks.indirect.pixels.size(); ++i) {
        off += std::abs(static_cast<double>(walks.indirect.pixels[i]) - stands.indirect.pixels[i]);
        sum += stands.indirect.pixels[i];
    }
    EXPECT_LT(off, 1e-3 * sum) << "photons are the same ones, wherever the camera was";
    EXPECT_GT(walks.figures.gi.median, 0);
}

}  // namespace trade_memory_test
}  // namespace lanthorn::tools
