// The headline figures of the project's scenes, against the path-traced reference, at 128x128 and preset
// medium.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <ostream>
#include <string_view>

#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "lanthorn/core/settings.h"
#include "tests/gpu/tools/headlines.h"
#include "tests/support/repository.h"
#include "tools/image_metrics/metrics.h"
#include "tools/lanthorn/common/plan_report.h"
#include "tools/lanthorn/load/load_scene.h"
#include "tools/lanthorn/measure/measure_flicker.h"
#include "tools/lanthorn/measure/measure_hits.h"
#include "tools/lanthorn/render/path_job.h"

namespace lanthorn::tools {

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

class Headlines : public testing::TestWithParam<Headline> {
  protected:
    Headlines() : settings_(schema()) {
        settings_.apply_preset("medium");
        settings_.set_from_text("gi.emc.rays=bvh");
        settings_.set<bool>("gi.gather.endless", false);  // the reference counts reflections
        settings_.set_from_text("gi.emc.final", GetParam().stage);
        settings_.set<int>("path.spp", kSpp);
    }

    static const SettingsSchema& schema() {
        static const auto declared = [] {
            auto made = std::make_unique<SettingsSchema>();
            declare_all_settings(*made);
            return made;
        }();
        return *declared;
    }
    static bool gathers() { return std::string_view(GetParam().stage) == "gather"; }
    static SceneView view() {
        SceneView result;
        result.camera = GetParam().camera;
        result.time = 0;
        return result;
    }
    static SceneData scene() {
        return load_scene(support::repository_file("assets/" + std::string(GetParam().scene) + ".glb"),
                          view());
    }
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
    static void hold(const char* what, double value, double ceiling, double stale) {
        std::printf("%-6s %-12s %-5s %-8s %.4f, at most %.4f\n", GetParam().stage, GetParam().scene,
                    GetParam().camera, what, value, ceiling);
        EXPECT_LE(value, ceiling) << what;
        EXPECT_GE(value, stale) << what << " has become better: lower its ceiling in headlines.h";
    }

    Settings settings_;
};

TEST_P(Headlines, ErrorAndFlux) {
    RenderJob job;
    job.size = kSize;
    job.view = view();
    job.aovs = {render::Aov::indirect};
    const RenderOutcome traced = path_trace_scene(scene(), settings_, job, "", [](double) {});
    const RenderOutcome shown = render_scene(scene(), settings_, job, [](int) {});
    const auto difference =
        image_metrics::compare(shown.images.front(), traced.images.front(), "emc", "path").all;
    const double noise = std::stod(traced.images.front().metadata.at("noise"));
    EXPECT_LT(noise, difference.relrmse);
    hold("relRMSE", std::sqrt(std::max(difference.relrmse * difference.relrmse - noise * noise, 0.0)),
         GetParam().relrmse, kStale * GetParam().relrmse);
    hold("flux", std::abs(difference.flux - 1), GetParam().flux, GetParam().flux - kStaleFlux);
}

TEST_P(Headlines, PhotonHits) {
    if (GetParam().misses == 0) {
        return;
    }
    HitCounts all;
    const PhotonFlights flights = trace_photons(scene(), settings_, view());
    for (const HitCounts& bounce : measure_hits(flights, [](std::uint64_t) {})) {
        all += bounce;
    }
    EXPECT_GT(all.segments, 10000u);
    hold("misses", 1 - all.share(all.agree), GetParam().misses, kStale * GetParam().misses);
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
}  // namespace lanthorn::tools
