// What each pass of the game's pictures takes while its levels play themselves, flames, bloom, beams and rims
// included:
//   bench_passes WIDTH HEIGHT PRESET FRAMES [LEVEL...]
// Medians over FRAMES, 15 a second of play from the middle of the tour on: milliseconds of processor time
// where OpenGL runs on the CPU, else of the GPU. Passes nest: `composite` has `glow`, `air` and `bloom` in
// it.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "game/level/campaign.h"
#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/time_step.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

constexpr std::uint64_t kStepsAFrame = 4;
constexpr int kWarmUp = 12;  // frames

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

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
    fmt::print("{}, {}x{}, {}: {:.1f} ms in all passes\n", stem, size.x, size.y, preset, median(whole));
    for (auto& [name, ms] : passes) {
        const std::size_t in = ms.size();
        ms.resize(whole.size(), 0);  // it was not there in the other frames
        fmt::print("  {:24} {:8.2f}  in {} of {} frames\n", name, median(ms), in, whole.size());
    }
}

int run(std::span<char*> arguments) {
    const auto number = [&](std::size_t i) { return i < arguments.size() ? std::atoi(arguments[i]) : 0; };
    const ivec2 size(number(1), number(2));
    const int frames = number(4);
    if (size.x < 1 || size.y < 1 || frames < 1) {
        fmt::print(stderr, "bench_passes: expected WIDTH HEIGHT PRESET FRAMES [LEVEL...], numbers above 0\n");
        return 2;
    }
    std::vector<std::string> levels(arguments.begin() + 5, arguments.end());
    if (levels.empty()) {
        levels.assign(campaign().begin(), campaign().end());
    }
    const auto context = gpu::create_headless_context();
    for (const std::string& stem : levels) {
        measure(stem, size, arguments[3], frames);
    }
    return 0;
}

}  // namespace
}  // namespace lanthorn::game

int main(int argc, char** argv) {
    try {
        return lanthorn::game::run(std::span(argv, static_cast<std::size_t>(argc)));
    } catch (const std::exception& e) {
        fmt::print(stderr, "bench_passes: {}\n", e.what());
        return 2;
    }
}
