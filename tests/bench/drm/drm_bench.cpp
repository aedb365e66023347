// Frisvad et al. 2005: what its tables and figures say, of `drm` as it is here.
//   bench_drm                    the three tables of errors below, 96 x 96, without cost; exit status 1 above
//   a ceiling bench_drm samples            sec. 5, why M = 3: each M by eq. 14, and each equation by M = 3
//   bench_drm near               Fig. 7: a ball close to the lamp, by each equation
//   bench_drm beyond             samples that are hidden, and a second bounce, against path of as many
//   bounces bench_drm table1 [SIDE [MANY]]   Table 1: frames a second by figure and part, SIDE x SIDE pixels
//   (512), and, unless
//                                MANY is 0, of a mesh of as many triangles as the Stanford Dragon's
// Errors are those of the indirect irradiance against path tracing, its noise taken off. Cost: milliseconds
// of processor time, all threads, of the indirect light in frames in which the lamps change, by that of the
// rest of the frame; medians.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/metrics.h"
#include "lanthorn/workbench/path_job.h"
#include "tests/bench/drm/drm_rows.h"
#include "tests/support/repository.h"
#include "tools/lanthorn/bench/paper_bench.h"
#include "tools/scene_generator/scenes.h"

using namespace lanthorn;
using namespace lanthorn::bench;
using namespace lanthorn::workbench;

namespace {

constexpr int kSide = 96;
constexpr int kSpp = 256;

Settings settings_of(const char* options) {
    static const auto schema = [] {
        auto made = std::make_unique<SettingsSchema>();
        declare_all_settings(*made);
        return made;
    }();
    Settings settings(*schema);
    settings.set_from_text("gi.technique=drm");
    settings.set<int>("path.spp", kSpp);
    const std::string text(options);
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find(' ', from), text.size());
        settings.set_from_text(text.substr(from, to - from));
        from = to + 1;
    }
    return settings;
}

RenderJob job_of(const char* camera) {
    RenderJob job;
    job.size = ivec2(kSide);
    job.view.time = 0;
    job.view.camera = camera;
    job.aovs = {render::Aov::indirect};
    return job;
}

SceneData scene_of(const char* name, const RenderJob& job) {
    return load_scene(support::repository_file(std::string("assets/") + name + ".glb"), job.view);
}

// References by scene, camera and bounces.
const ImageF& truth(const ErrorRow& row) {
    static std::map<std::string, ImageF> kept;
    const std::string key = fmt::format("{}@{} {}", row.scene, row.camera, row.bounces);
    const auto [at, missing] = kept.try_emplace(key);
    if (missing) {
        const RenderJob job = job_of(row.camera);
        Settings settings = settings_of("");
        settings.set<int>("gi.bounces", row.bounces);
        settings.set<bool>("gi.gather.endless", false);  // path counts bounces then, whatever the number
        at->second =
            path_trace_scene(scene_of(row.scene, job), settings, job, "", [](double) {}).images.front();
    }
    return at->second;
}

// Indirect light by the rest of the frame.
std::string cost_of(const ErrorRow& row, const RenderJob& job, const Settings& settings) {
    tools::PaperJob timed;
    timed.size = job.size;
    timed.frames = 5;
    timed.warmup = 2;
    const tools::PaperFigures cost = tools::measure_row(scene_of(row.scene, job), settings, timed);
    return fmt::format("{:.2f}", cost.gi_cpu / cost.direct_cpu());
}

// False: above a ceiling.
bool measure(const ErrorRow& row, bool with_cost) {
    const RenderJob job = job_of(row.camera);
    const Settings settings = settings_of(row.options);
    const ImageF& expected = truth(row);
    const RenderOutcome shown = render_scene(scene_of(row.scene, job), settings, job, [](int) {});
    const auto difference = compare(shown.images.front(), expected, "drm", "path").all;
    const double noise = std::stod(expected.metadata.at("noise"));
    const double error = std::sqrt(std::max(difference.relrmse * difference.relrmse - noise * noise, 0.0));
    fmt::print("| {}{}{} | {} | {} | {:.3f} | {:.3f} | {} |\n", row.scene, *row.camera != '\0' ? "@" : "",
               row.camera, row.options, row.bounces, difference.flux, error,
               with_cost ? cost_of(row, job, settings) : "-");
    if (error > row.relrmse || std::abs(difference.flux - 1) > row.flux) {
        fmt::print("above its ceiling: relRMSE {}, flux off by {}\n", row.relrmse, row.flux);
        return false;
    }
    return true;
}

bool errors(const char* title, std::span<const ErrorRow> rows, bool with_cost) {
    fmt::print("{}\n| scene | settings | bounces | flux | relRMSE | cost |\n|---|---|---|---|---|---|\n",
               title);
    bool holds = true;
    for (const ErrorRow& row : rows) {
        holds = measure(row, with_cost) && holds;
        std::fflush(stdout);
    }
    fmt::print("\n");
    return holds;
}

void table1(int side, bool many) {
    fmt::print(
        "Table 1, {0} x {0}\n| figure | part | paper, fps | ours, fps | direct light is times as fast: paper "
        "| "
        "ours |\n|---|---|---|---|---|---|\n",
        side);
    tools::PaperJob job;
    job.size = ivec2(side);
    job.frames = 5;
    job.warmup = 2;
    double direct = 0, paper_direct = 0;
    for (const SpeedRow& row : kSpeedRows) {
        const bool dragon = std::string(row.scene) == "dragon_sized";
        if (dragon && !many) {
            continue;
        }
        const SceneData scene = dragon ? scene_generator::dragon_sized() : scene_of(row.scene, job_of(""));
        const double ms = tools::measure_row(scene, settings_of(row.options), job).frame_cpu;
        if (row.first) {
            direct = ms;
            paper_direct = row.fps;
        }
        const auto number = [](double v) { return v > 0 ? fmt::format("{:.2f}", v) : std::string("-"); };
        fmt::print("| {} | {} | {} | {:.2f} | {} | {:.2f} |\n", row.figure, row.part, number(row.fps),
                   1000 / ms, row.fps > 0 && paper_direct > 0 ? number(paper_direct / row.fps) : "-",
                   ms / direct);
        std::fflush(stdout);
    }
    fmt::print("The paper's: GeForce FX 5950. Ours: processor time of all threads.\n");
}

}  // namespace

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    try {
        if (what == "table1") {
            const int side = argc > 2 ? std::atoi(argv[2]) : 512;
            if (side < 1) {
                fmt::print(stderr, "bench_drm: '{}' where pixels were expected, at least 1\n", argv[2]);
                return 2;
            }
            table1(side, argc <= 3 || std::string(argv[3]) != "0");
            return 0;
        }
        if (!what.empty() && what != "samples" && what != "near" && what != "beyond") {
            fmt::print(stderr, "bench_drm: found '{}', expected samples, near, beyond or table1\n", what);
            return 2;
        }
        bool holds = true;
        const auto table = [&](const char* name, const char* title, std::span<const ErrorRow> rows) {
            if (what.empty() || what == name) {
                holds = errors(title, rows, !what.empty()) && holds;
            }
        };
        table("samples", "Sec. 5, samples", kSampleRows);
        table("near", "Fig. 7, a ball near the lamp", kNearRows);
        table("beyond", "Beyond", kBeyondRows);
        return holds ? 0 : 1;
    } catch (const Error& error) {
        fmt::print(stderr, "bench_drm: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
