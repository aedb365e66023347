// Errors that are estimated without a reference, beside the true ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "lanthorn/workbench/all_settings.h"
#include "tests/support/repository.h"
#include "tools/workbench/measure/measure_estimate.h"

namespace lanthorn::workbench {
namespace estimate_test {

MotionScene scene_of(const std::string& name) {
    SceneView view;
    view.time = 0;
    return {name, load_scene(support::repository_file("assets/" + name + ".glb"), view), view};
}

MotionCase with(const SettingsSchema& schema, const std::vector<std::string>& set) {
    MotionCase result{"medium", measured_settings(schema)};
    result.settings.apply_preset("medium");
    result.settings.set<bool>("gi.gather.endless", false);
    result.settings.set_from_text("gi.emc.rays=bvh");
    for (const std::string& assignment : set) {
        result.settings.set_from_text(assignment);
    }
    return result;
}

// Of all scenes, by medium with `set` on top.
std::vector<EstimatePoint> points_of(const std::vector<std::string>& scenes, const MotionJob& job,
                                     ReferencePairs& references, const std::vector<std::string>& set = {}) {
    SettingsSchema schema;
    declare_all_settings(schema);
    std::vector<EstimatePoint> points;
    for (const std::string& scene : scenes) {
        std::ranges::move(measure_estimates(scene_of(scene), {with(schema, set)}, job, references, [] {}),
                          std::back_inserter(points));
    }
    return points;
}

TEST(ErrorEstimate, IsNearTheTruthWhereItWasFitted) {
    MotionJob job;
    job.size = {128, 128};
    job.frames = 18;
    job.motions = {Motion::rest, Motion::lamp};
    ReferencePairs references("", 128);
    const std::vector<EstimatePoint> points = points_of({"clutter", "lantern-room"}, job, references);
    for (const EstimatePoint& p : points) {
        std::printf("%s, %s: relRMSE %.3f (%.3f to %.3f) for %.3f, local %.3f for %.3f\n", p.scene.c_str(),
                    p.motion.c_str(), p.estimate.relrmse.value, p.estimate.relrmse.low,
                    p.estimate.relrmse.high, p.truth.relrmse, p.estimate.local.value, p.truth.local);
    }
    ASSERT_GE(points.size(), 4u);
    EXPECT_GE(share_within(points, EstimatedFigure::relrmse, 2), 0.85);
    EXPECT_GE(share_within(points, EstimatedFigure::local, 2), 0.85);
}

// More rays have less noise, and it is noise that halves tell: four times as many, about half.
TEST(ErrorEstimate, NoiseByHalvesFallsWithRays) {
    MotionJob job;
    job.size = {96, 96};
    job.frames = 18;
    job.motions = {Motion::rest};
    ReferencePairs references("", 16);
    const auto noise = [&](const char* rays) {
        return points_of({"cornell"}, job, references, {std::string("gi.gather.rays=") + rays})
            .at(0)
            .estimate.relrmse_parts.noise;
    };
    const double few = noise("4"), many = noise("16");
    EXPECT_GT(few, 1.5 * many);
    EXPECT_LT(few, 40 * many);
}

TEST(ErrorEstimate, IsNotKnownOfWhatHasNone) {
    MotionJob job;
    job.size = {32, 32};
    job.frames = 4;
    job.motions = {Motion::rest};
    ReferencePairs references("", 4);
    for (const char* set : {"gi.technique=none", "gi.emc.final=splat"}) {
        EXPECT_TRUE(points_of({"cornell"}, job, references, {set}).empty()) << set;
    }
}

}  // namespace estimate_test
}  // namespace lanthorn::workbench
