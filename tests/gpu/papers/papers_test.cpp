// Each paper's technique as published, against path tracing of as many bounces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <ostream>
#include <string_view>

#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/measure_coverage.h"
#include "lanthorn/workbench/measure_hits.h"
#include "lanthorn/workbench/metrics.h"
#include "lanthorn/workbench/path_job.h"
#include "tests/gpu/papers/paper_figures.h"
#include "tests/support/repository.h"

namespace lanthorn::workbench {

// For GoogleTest's messages.
void PrintTo(const PaperFigure& figure, std::ostream* out) {
    *out << figure.technique << " " << figure.scene;
}

namespace {

constexpr ivec2 kSize(96);
constexpr int kSpp = 128;  // of the reference

class Papers : public testing::TestWithParam<PaperFigure> {
  protected:
    Papers() : settings_(schema()) {
        settings_.apply_preset(kPaperPreset);
        settings_.set_from_text("gi.technique", GetParam().technique);
        settings_.set<int>("path.spp", kSpp);
        // Lavignotte and Paulin's photons are scattered by the whole BSDF; the others' evenly.
        const bool whole = std::string_view(GetParam().technique) == "splat";
        settings_.set_from_text("path.transport", whole ? "full" : "diffuse");
    }

    static const SettingsSchema& schema() {
        static const auto declared = [] {
            auto made = std::make_unique<SettingsSchema>();
            declare_all_settings(*made);
            return made;
        }();
        return *declared;
    }
    static SceneView view() {
        SceneView result;
        result.time = 0;
        return result;
    }
    static SceneData scene() {
        return load_scene(support::repository_file("assets/" + std::string(GetParam().scene) + ".glb"),
                          view());
    }
    static void hold(const char* what, double value, double ceiling, double stale) {
        std::printf("%-10s %-12s %-8s %.4f, at most %.4f\n", GetParam().technique, GetParam().scene, what,
                    value, ceiling);
        EXPECT_LE(value, ceiling) << what;
        EXPECT_GE(value, stale) << what << " has become better: lower its ceiling in paper_figures.h";
    }

    Settings settings_;
};

TEST_P(Papers, ErrorAndFlux) {
    RenderJob job;
    job.size = kSize;
    job.view = view();
    job.aovs = {render::Aov::indirect};
    const RenderOutcome traced = path_trace_scene(scene(), settings_, job, "", [](double) {});
    const RenderOutcome shown = render_scene(scene(), settings_, job, [](int) {});
    EXPECT_EQ(shown.nan_count, 0u);
    const auto difference = compare(shown.images.front(), traced.images.front(), "paper", "path").all;
    const double noise = std::stod(traced.images.front().metadata.at("noise"));
    hold("relRMSE", std::sqrt(std::max(difference.relrmse * difference.relrmse - noise * noise, 0.0)),
         GetParam().relrmse, kStalePaper * GetParam().relrmse);
    hold("flux", std::abs(difference.flux - 1), GetParam().flux, GetParam().flux - 0.03);
    EXPECT_GT(difference.flux, 0.2) << "the picture is not black";
}

TEST_P(Papers, HitsAndCoverage) {
    if (GetParam().misses == 0) {
        return;
    }
    settings_.set<int>("gi.photons", 20'000);  // a share, and enough of them to know it
    constexpr int kPoints = 4000;
    HitCounts all;
    const PhotonFlights flights = trace_photons(scene(), settings_, view());
    for (const HitCounts& bounce : measure_hits(flights, [](std::uint64_t) {})) {
        all += bounce;
    }
    EXPECT_GT(all.segments, 10000u);
    hold("misses", 1 - all.share(all.agree), GetParam().misses, kStalePaper * GetParam().misses);
    const CoverageFigures seen = measure_coverage(flights, kPoints, 1, [](std::uint64_t) {});
    hold("unseen", 1 - seen.coverage, GetParam().unseen, GetParam().unseen - 0.01);
}

std::string test_name(const testing::TestParamInfo<PaperFigure>& info) {
    std::string name = std::string(info.param.technique) + '_' + info.param.scene;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(AsPublished, Papers, testing::ValuesIn(kPaperFigures), test_name);

}  // namespace
}  // namespace lanthorn::workbench
