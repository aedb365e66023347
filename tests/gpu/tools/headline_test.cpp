// The headline figures of the project's scenes, against the path-traced reference, at 128x128 and preset
// medium.
#include <algorithm>
#include <ostream>
#include <string_view>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/workbench/measure_flicker.h"
#include "tests/gpu/tools/headlines.h"
#include "tests/gpu/tools/held_figures.h"

namespace lanthorn::workbench {

// For GoogleTest's messages.
void PrintTo(const Headline& view, std::ostream* out) {
    *out << view.stage << " " << view.scene << " " << view.camera;
}

namespace {

constexpr ivec2 kSize(128);
constexpr int kSpp = 256;  // of the reference
constexpr ivec2 kFlickerSize(96);
constexpr int kFlickerFrames = 4;
constexpr int kFlickerWarmup = 2, kGatherWarmup = gi::RememberedHits::kFrames;
constexpr int kMeanSpp = 16;  // of the reference's mean, which flicker is relative to
constexpr double kStale = 0.9;
constexpr double kStaleFlux = 0.01;  // below the ceiling: the flux ratio may come near 1 by luck

class Headlines : public HeldFigures, public testing::WithParamInterface<Headline> {
  protected:
    Headlines() : HeldFigures({GetParam().stage, GetParam().scene, GetParam().camera, "headlines.h"}, kSize) {
        settings_.apply_preset("medium");
        settings_.set_from_text("gi.emc.rays=bvh");
        settings_.set<bool>("gi.gather.endless", false);  // the reference counts reflections
        settings_.set_from_text("gi.emc.final", GetParam().stage);
        settings_.set<int>("path.spp", kSpp);
    }

    static bool gathers() { return std::string_view(GetParam().stage) == "gather"; }
    void hold_flicker(const char* what, FlickerMotion motion, const Flicker& flicker) const {
        FlickerJob job;
        job.size = kFlickerSize;
        job.view = view();
        job.motion = motion;
        job.frames = kFlickerFrames;
        job.warmup = gathers() ? kGatherWarmup : kFlickerWarmup;
        job.spp = kMeanSpp;
        const FlickerFigures f = measure_flicker(scene(), settings_, job, [](std::uint64_t) {});
        hold(what, f.change / (flicker.truth * f.reference_mean), flicker.ceiling, kStale * flicker.ceiling);
    }
};

TEST_P(Headlines, ErrorAndFlux) {
    hold_error({GetParam().relrmse, kStale * GetParam().relrmse},
               {GetParam().flux, GetParam().flux - kStaleFlux});
}

TEST_P(Headlines, PhotonHits) {
    if (GetParam().misses != 0) {
        hold_misses({GetParam().misses, kStale * GetParam().misses});
    }
}

TEST_P(Headlines, FlickerUnderAMovingLight) {
    hold_flicker("light", FlickerMotion::light, GetParam().light);
}

TEST_P(Headlines, FlickerInAPan) {
    hold_flicker("pan", FlickerMotion::pan, GetParam().pan);
}

std::string test_name(const testing::TestParamInfo<Headline>& info) {
    std::string name = std::string(info.param.stage) + '_' + info.param.scene +
                       (*info.param.camera ? "_" : "") + info.param.camera;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Headlines, testing::ValuesIn(kHeadlines), test_name);

}  // namespace
}  // namespace lanthorn::workbench
