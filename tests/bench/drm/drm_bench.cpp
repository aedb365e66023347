// Frisvad et al. 2005: the cost and the error of `drm` with each of the paper's equations, M = 3, and with
// each M, eq. 14 (sec. 5: why M = 3). Against path tracing of one bounce; milliseconds are the processor's,
// all threads, of the second frame's gather after an unchanged first, medians of 5.
//   bench_drm [SIDE [SCENE...]]   SIDE x SIDE pixels, 96 by default; scenes of assets/, cornell by default
// At 96 x 96 in cornell errors and flux hold ceilings, which only go down: exit status 1 above one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/metrics.h"
#include "lanthorn/workbench/path_job.h"
#include "tests/support/repository.h"

using namespace lanthorn;
using namespace lanthorn::workbench;

namespace {

constexpr int kSide = 96;
constexpr int kSpp = 256;
constexpr int kFrames = 5;

struct Row {
    const char* equation;  // gi.drm.solid_angle
    int samples;           // M
    double relrmse, flux;  // ceilings, of the error and of the flux ratio's distance from 1: cornell, kSide
};

constexpr Row kRows[] = {{"11", 3, 2.87, 2.36},     {"15", 3, 1.01, 0.661}, {"14", 3, 0.548, 0.243},
                         {"disc", 3, 0.545, 0.028}, {"14", 2, 0.696, 0.45}, {"14", 4, 0.491, 0.222},
                         {"14", 5, 0.454, 0.13},    {"14", 16, 0.298, 0.04}};

struct Found {
    double relrmse = 0, flux = 0, ms = 0;
};

Found measure(const Row& row, const std::string& scene, const RenderJob& job, const ImageF& truth,
              Settings settings) {
    settings.set_from_text("gi.technique=drm");
    settings.set_from_text("gi.drm.solid_angle", row.equation);
    settings.set<int>("gi.drm.samples", row.samples);
    const RenderOutcome shown = render_scene(load_scene(scene, job.view), settings, job, [](int) {});
    const auto difference = compare(shown.images.front(), truth, "drm", "path").all;
    const double noise = std::stod(truth.metadata.at("noise"));
    std::vector<double> times;
    for (const FrameTiming& frame : shown.frames) {
        times.push_back(frame.cpu_ms);
    }
    std::ranges::sort(times);
    return {std::sqrt(std::max(difference.relrmse * difference.relrmse - noise * noise, 0.0)),
            difference.flux, times[times.size() / 2]};
}

// False: above a ceiling.
bool table(const std::string& name, int side) {
    SettingsSchema schema;
    declare_all_settings(schema);
    Settings settings(schema);
    settings.set<int>("gi.bounces", 1);
    settings.set<int>("path.spp", kSpp);
    const std::string scene = support::repository_file("assets/" + name + ".glb");
    RenderJob job;
    job.size = ivec2(side);
    job.view.time = 0;
    job.aovs = {render::Aov::indirect};
    const ImageF truth =
        path_trace_scene(load_scene(scene, job.view), settings, job, "", [](double) {}).images.front();
    job.frames = kFrames;
    job.warmup = 1;
    fmt::print("{}, {} x {}\n| equation | M | flux | relRMSE | frame, ms |\n|---|---|---|---|---|\n", name,
               side, side);
    bool holds = true;
    for (const Row& row : kRows) {
        const Found found = measure(row, scene, job, truth, settings);
        fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.1f} |\n", row.equation, row.samples, found.flux,
                   found.relrmse, found.ms);
        if (name == "cornell" && side == kSide &&
            (found.relrmse > row.relrmse || std::abs(found.flux - 1) > row.flux)) {
            fmt::print("above its ceiling: relRMSE {}, flux off by {}\n", row.relrmse, row.flux);
            holds = false;
        }
    }
    return holds;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const int side = argc > 1 ? std::atoi(argv[1]) : kSide;
        if (side < 1) {
            fmt::print(stderr, "bench_drm: '{}' where pixels were expected, at least 1\n", argv[1]);
            return 2;
        }
        const std::vector<std::string> scenes =
            argc > 2 ? std::vector<std::string>(argv + 2, argv + argc) : std::vector<std::string>{"cornell"};
        bool holds = true;
        for (const std::string& scene : scenes) {
            holds = table(scene, side) && holds;
        }
        return holds ? 0 : 1;
    } catch (const Error& error) {
        fmt::print(stderr, "bench_drm: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
