// What each pass of the game's pictures takes while its levels play themselves, flames, bloom, beams and rims
// included:
//   bench_passes WIDTH HEIGHT PRESET FRAMES [KEY=VALUE...] [LEVEL...]
// Medians over FRAMES, 15 a second of play from the middle of the tour on: milliseconds of processor time
// where OpenGL runs on the CPU, else of the GPU. Passes nest: `composite` has `glow`, `air` and `bloom` in
// it. With settings half of the frames are drawn with them, by turns, FRAMES of either kind, and a second
// column has their medians: what a setting of the picture costs, whatever else the machine does.
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "game/level/campaign.h"
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
constexpr unsigned kWarmUp = 12;  // frames

// Of the frames of one kind.
struct Times {
    std::vector<double> whole;
    std::map<std::string, std::vector<double>> passes;

    void add(const std::vector<gpu::PassTimer::Span>& spans) {
        std::map<std::string, double> frame;
        double sum = 0;
        for (const gpu::PassTimer::Span& span : spans) {
            const double ms = span.cpu_ms > 0 ? span.cpu_ms : span.ms;
            frame[span.name] += ms;
            for (const char* outer : {"upload", "gbuffer", "light_maps", "gi", "direct", "composite"}) {
                sum += span.name == outer ? ms : 0;
            }
        }
        whole.push_back(sum);
        for (const auto& [name, ms] : frame) {
            passes[name].push_back(ms);
        }
    }
    std::size_t frames_with(const std::string& pass) const {
        const auto found = passes.find(pass);
        return found != passes.end() ? found->second.size() : 0;
    }
    double median_of(const std::string& pass) const {
        const auto found = passes.find(pass);
        std::vector<double> ms = found != passes.end() ? found->second : std::vector<double>();
        ms.resize(whole.size(), 0);  // it was not there in the other frames
        return support::median(std::move(ms));
    }
};

// As a row: a pass, its median of each kind of frames, in how many of them it was.
void print(const std::string& pass, const std::vector<Times>& kinds) {
    fmt::print("  {:24}", pass);
    for (const Times& times : kinds) {
        fmt::print(" {:8.2f} in {} of {} frames", times.median_of(pass), times.frames_with(pass),
                   times.whole.size());
    }
    fmt::print("\n");
}

void measure(const std::string& stem, ivec2 size, const Options& plain, const std::vector<std::string>& set,
             int frames) {
    Options options = plain;
    options.level = support::repository_file("assets/levels/" + stem + ".glb");
    Playthrough level(options, import_gltf(options.level));
    App& app = level.app();
    const Quality quality(options, level.session().seed());
    gi::add_picture_plugins(app, quality.settings(), true);
    app.add<PresentPlugin>();
    app.view().size = size;
    options.set = set;
    const Quality altered(options, level.session().seed());
    std::vector<Times> kinds(set.empty() ? 1 : 2);
    std::uint64_t step = *level.session().length() / 2;
    const auto count = static_cast<unsigned>(kinds.size());
    for (unsigned i = 0; i < count * (kWarmUp + static_cast<unsigned>(frames)); ++i, step += kStepsAFrame) {
        // In the order of Thue and Morse: what comes every so many frames falls to both kinds alike.
        const unsigned kind = count > 1 ? static_cast<unsigned>(std::popcount(i)) % 2 : 0;
        (kind == 0 ? quality : altered).draw(app);
        app.show_at(static_cast<double>(step) / kStepsPerSecond);
        const std::vector<gpu::PassTimer::Span> spans = app.world().resource<Renderer>().timer->end_frame();
        if (i >= count * kWarmUp) {
            kinds[kind].add(spans);
        }
    }
    fmt::print("{}, {}x{}, {}:", stem, size.x, size.y, options.preset);
    for (const Times& times : kinds) {
        fmt::print(" {:.1f} ms", support::median(times.whole));
    }
    fmt::print(" in all passes\n");
    std::set<std::string> names;
    for (const Times& times : kinds) {
        for (const auto& [name, ms] : times.passes) {
            names.insert(name);
        }
    }
    for (const std::string& name : names) {
        print(name, kinds);
    }
}

}  // namespace
}  // namespace lanthorn::game

int main(int argc, char** argv) {
    using namespace lanthorn;
    const game::LevelBench bench{"bench_passes", "WIDTH HEIGHT PRESET FRAMES"};
    return bench.run(argc, argv,
                     [&](const std::vector<std::string>& words, const std::vector<std::string>& more) {
                         const ivec2 size(bench.number(words[0]), bench.number(words[1]));
                         const int frames = bench.number(words[3]);
                         game::Options options;
                         options.headless = true;
                         options.preset = words[2];
                         std::vector<std::string> set, levels;
                         for (const std::string& word : more) {
                             (word.find('=') != std::string::npos ? set : levels).push_back(word);
                         }
                         if (levels.empty()) {
                             levels.assign(game::campaign().begin(), game::campaign().end());
                         }
                         for (const std::string& stem : levels) {
                             game::measure(stem, size, options, set, frames);
                         }
                     });
}
