// A figure that walks with its lantern: the light moves, what bends throws its shadow, and most of the light
// that is reflected leaves things of a few centimetres. Held against the reference and against `coarse-path`.
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>

#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/measure_motions.h"
#include "tests/support/repository.h"

namespace lanthorn::workbench {
namespace {

MotionCase medium(const SettingsSchema& schema, const char* technique) {
    MotionCase result{technique, Settings(schema)};
    result.settings.apply_preset("medium");
    result.settings.set_from_text("gi.technique", technique);
    result.settings.set_from_text("gi.emc.rays=bvh");
    result.settings.set<bool>("gi.gather.endless", false);  // the reference counts reflections
    return result;
}

TEST(Figures, AWalkingLanternErrsLessThanCoarsePaths) {
    SettingsSchema schema;
    declare_all_settings(schema);
    SceneView view;
    view.time = 0;
    const MotionScene scene{"puppet", load_scene(support::repository_file("assets/puppet.glb"), view), view};
    MotionJob job;
    job.size = {256, 144};
    job.frames = 30;
    job.motions = {Motion::figure};
    ReferencePairs references("", 256);
    const auto figures = measure_motions(scene, {medium(schema, "emc"), medium(schema, "coarse-path")}, job,
                                         references, [] {});
    const MotionFigures& emc = figures[0][0];
    const MotionFigures& coarse = figures[1][0];
    for (const MotionFigures* f : {&emc, &coarse}) {
        std::printf("%s: relRMSE %.3f, local %.3f, flux %.4f\n", f == &emc ? "emc" : "coarse-path",
                    f->error.relrmse, f->error.local, f->error.flux);
    }
    EXPECT_LE(emc.error.relrmse, 0.40);
    EXPECT_GE(emc.error.flux, 0.965);  // found: 0.972; wanted: 0.97
    EXPECT_LE(emc.error.flux, 1.03);
    EXPECT_LT(emc.error.relrmse, coarse.error.relrmse);
    EXPECT_LT(emc.error.local, 0.7 * coarse.error.local);
    EXPECT_EQ(emc.nan_count, 0U);
}

}  // namespace
}  // namespace lanthorn::workbench
