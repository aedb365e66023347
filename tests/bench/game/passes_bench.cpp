// What each pass of the game's pictures takes while its levels play themselves, flames, bloom, beams and rims
// included:
//   bench_passes WIDTH HEIGHT PRESET FRAMES [LEVEL...]
// Medians over FRAMES, 15 a second of play from the middle of the tour on: milliseconds of processor time
// where OpenGL runs on the CPU, else of the GPU. Passes nest: `composite` has `glow`, `air` and `bloom` in
// it.
#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/time_step.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tests/bench/game/level_bench.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

constexpr std::uint64_t kStepsAFrame = 4;
constexpr int kWarmUp = 12;  // frames

void measure(const std::string& stem, ivec2 size, const std::string& preset, int frames) {
    Options options;
    options.headless = true;
    options.preset = preset;
    options.level = support::repository_file("assets/levels/" + stem + ".glb");
    Playthrough level(options, import_gltf(options.level));
    App& app = level.app();
    const Quality quality(options, level.session().seed());
    gi::add_picture_plugins(app, quality.settings(), true);
    app.add<PresentPlugin>();
    app.view().size = size;
    std::uint64_t step = *level.session().length() / 2;
    std::map<std::string, std::vector<double>> passes;
    std::vector<double> whole;
    for (int i = -kWarmUp; i < frames; ++i, step += kStepsAFrame) {
        app.show_at(static_cast<double>(step) / kStepsPerSecond);
        std::map<std::string, double> frame;
        double sum = 0;
        for (const gpu::PassTimer::Span& span : app.world().resource<Renderer>().timer->end_frame()) {
            const double ms = span.cpu_ms > 0 ? span.cpu_ms : span.ms;
            frame[span.name] += ms;
            for (const char* outer : {"upload", "gbuffer", "light_maps", "gi", "direct", "composite"}) {
                sum += span.name == outer ? ms : 0;
            }
        }
        if (i >= 0) {
            whole.push_back(sum);
            for (const auto& [name, ms] : frame) {
                passes[name].push_back(ms);
            }
        }
    }
    fmt::print("{}, {}x{}, {}: {:.1f} ms in all passes\n", stem, size.x, size.y, preset,
               support::median(whole));
    for (auto& [name, ms] : passes) {
        const std::size_t in = ms.size();
        ms.resize(whole.size(), 0);  // it was not there in the other frames
        fmt::print("  {:24} {:8.2f}  in {} of {} frames\n", name, support::median(ms), in, whole.size());
    }
}

}  // namespace
}  // namespace lanthorn::game

int main(int argc, char** argv) {
    using namespace lanthorn;
    const game::LevelBench bench{"bench_passes", "WIDTH HEIGHT PRESET FRAMES"};
    return bench.run(argc, argv,
                     [&](const std::vector<std::string>& words, const std::vector<std::string>& levels) {
                         const ivec2 size(bench.number(words[0]), bench.number(words[1]));
                         const int frames = bench.number(words[3]);
                         for (const std::string& stem : levels) {
                             game::measure(stem, size, words[2], frames);
                         }
                     });
}
