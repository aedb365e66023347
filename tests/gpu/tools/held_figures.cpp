#include "tests/gpu/tools/held_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <utility>

#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/path_job.h"
#include "tests/support/repository.h"

namespace lanthorn::workbench {

namespace {

const SettingsSchema& schema() {
    static const auto declared = [] {
        auto made = std::make_unique<SettingsSchema>();
        declare_all_settings(*made);
        return made;
    }();
    return *declared;
}

}  // namespace

HeldFigures::HeldFigures(Row row, ivec2 size) : settings_(schema()), row_(std::move(row)), size_(size) {}

SceneView HeldFigures::view() const {
    SceneView result;
    result.camera = row_.camera;
    result.time = 0;
    return result;
}

SceneData HeldFigures::scene() const {
    return load_scene(support::repository_file("assets/" + row_.scene + ".glb"), view());
}

void HeldFigures::hold(const char* what, double value, double ceiling, double stale) const {
    std::printf("%-10s %-12s %-5s %-8s %.4f, at most %.4f\n", row_.name.c_str(), row_.scene.c_str(),
                row_.camera.c_str(), what, value, ceiling);
    EXPECT_LE(value, ceiling) << what;
    EXPECT_GE(value, stale) << what << " has become better: lower its ceiling in " << row_.table;
}

Difference HeldFigures::hold_error(const Held& relrmse, const Held& flux) const {
    RenderJob job;
    job.size = size_;
    job.view = view();
    job.aovs = {render::Aov::indirect};
    const RenderOutcome traced = path_trace_scene(scene(), settings_, job, "", [](double) {});
    const RenderOutcome shown = render_scene(scene(), settings_, job, [](int) {});
    EXPECT_EQ(shown.nan_count, 0u);
    const auto difference = compare(shown.images.front(), traced.images.front(), row_.name, "path").all;
    const double noise = std::stod(traced.images.front().metadata.at("noise"));
    EXPECT_LT(noise, difference.relrmse);
    hold("relRMSE", std::sqrt(std::max(difference.relrmse * difference.relrmse - noise * noise, 0.0)),
         relrmse.ceiling, relrmse.stale);
    hold("flux", std::abs(difference.flux - 1), flux.ceiling, flux.stale);
    return difference;
}

PhotonFlights HeldFigures::hold_misses(const Held& misses) const {
    HitCounts all;
    PhotonFlights flights = trace_photons(scene(), settings_, view());
    for (const HitCounts& bounce : measure_hits(flights, [](std::uint64_t) {})) {
        all += bounce;
    }
    EXPECT_GT(all.segments, 10000u);
    hold("misses", 1 - all.share(all.agree), misses.ceiling, misses.stale);
    return flights;
}

}  // namespace lanthorn::workbench
