// No preset is dominated by another: from low to ultra each costs more and errs less. Costs are counted in
// work, not in time, so that the verdict is the same on every machine.
#include <gtest/gtest.h>

#include <map>

#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/trade_measure.h"
#include "tests/support/repository.h"
#include "tests/unit/tools/run_program.h"
#include "tools/lanthorn/common/child_process.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {
namespace {

constexpr const char* kSize = "128x128";
constexpr ivec2 kPixels(128);
// Between presets of equally many bounces, what both leave out is most of the error against all bounces.
constexpr double kAllBounces = 1.1;

class Presets : public testing::TestWithParam<const char*> {
  protected:
    Presets() { declare_all_settings(schema_); }

    std::string trace(const std::string& name, const std::string& aov, const std::string& setting) const {
        const std::string file = folder_.path(name);
        const ChildOutcome outcome = run_child(
            {LANTHORN_BINARY, "render", scene(), "-o", file, "--technique", "path", "--aov", aov, "--size",
             kSize, "--spp", "192", "--seed", "7001", "--set", "gi.gather.endless=false", "--set", setting});
        EXPECT_TRUE(outcome.ok()) << outcome.why();
        return file;
    }
    // Traced once: presets share numbers of bounces.
    std::string of_bounces(int bounces) {
        std::string& file = of_bounces_[bounces];
        if (file.empty()) {
            const std::string count = std::to_string(bounces);
            file = trace(count + ".exr", "indirect", "gi.bounces=" + count);
        }
        return file;
    }
    static std::string scene() {
        return support::repository_file("assets/" + std::string(GetParam()) + ".glb");
    }

    SettingsSchema schema_;
    testing_tools::TemporaryFolder folder_;
    std::map<int, std::string> of_bounces_;
};

TEST_P(Presets, ErrFallsAsWorkRises) {
    const TradeReferences all = {trace("all.exr", "indirect", "path.unlimited=true"), folder_.path("all.exr"),
                                 trace("final.exr", "final", "path.unlimited=true")};
    double last_error = 1e9, last_error_all = 1e9, last_segments = 0;
    for (const std::string_view preset : kPresetNames) {
        const TradePoint point{scene(), "emc", std::string(preset), {}, {}};
        const Settings settings = point.settings(schema_);
        TradeReferences references = all;
        references.same = of_bounces(settings.get<int>("gi.bounces"));
        TradeView view = view_point(point, {kPixels, {}, 1, 0}, schema_);
        compare_with_references(view, references);
        const TradeFigures& f = view.figures;
        const double segments =
            static_cast<double>(settings.get<int>("gi.photons")) * settings.get<int>("gi.bounces");
        RecordProperty(std::string(preset) + "_relrmse", std::to_string(f.relrmse));
        EXPECT_LT(f.relrmse, last_error) << preset << " errs no less than the preset below it";
        EXPECT_LT(f.relrmse_all, kAllBounces * last_error_all) << preset << ", against all bounces";
        EXPECT_GT(segments, last_segments) << preset << " traces no more than the preset below it";
        EXPECT_EQ(f.nan_count, 0);
        last_error = f.relrmse;
        last_error_all = f.relrmse_all;
        last_segments = segments;
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Presets, testing::Values("cornell", "two-rooms"), [](const auto& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace lanthorn::tools
