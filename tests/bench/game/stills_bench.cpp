// How far the stills of the levels' recorded sessions are from the path tracer's, all light and all
// materials:
//   bench_stills WIDTH HEIGHT BATCHES SPP [LEVEL...]
// Three a level, as `lamplighter --tour` shows them: as it is found, on the way, solved; at preset medium.
// The reference is the median of BATCHES pictures of SPP samples a pixel, channel by channel: a path that
// meets a small lamp by chance makes a pixel of one picture shine, and the median leaves it out. What it is
// worth is said by two medians of half of the batches each. All with the exposure of the still. Pictures go
// into the folder `stills`.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "engine/render/radiance_picture.h"
#include "game/level/title_camera.h"
#include "game/presentation/playthrough.h"
#include "game/presentation/quality.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/reference/path_tracer.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/workbench/flip.h"
#include "tests/bench/game/level_bench.h"
#include "tests/support/repository.h"

namespace lanthorn::game {
namespace {

constexpr int kSettling = 20;              // frames, as of the tour
constexpr std::uint64_t kAfterwards = 96;  // steps, likewise

struct Wanted {
    ivec2 size{0};
    int batches = 0, spp = 0;
};

template <class T>
double mean(const std::vector<T>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<float> median(std::span<const std::vector<float>> pictures) {
    std::vector<float> result(pictures.front().size());
    std::vector<float> values(pictures.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        for (std::size_t b = 0; b < pictures.size(); ++b) {
            values[b] = pictures[b][i];
        }
        std::ranges::sort(values);
        const std::size_t half = values.size() / 2;
        result[i] = values.size() % 2 == 1 ? values[half] : 0.5f * (values[half - 1] + values[half]);
    }
    return result;
}

// Radiance through the renderer's own tone map, exposed as the still.
ImageF displayed(const std::vector<float>& radiance, const std::vector<float>& coverage, ivec2 size,
                 render::RenderSettings settings, float exposure) {
    settings.exposure_mode = render::ExposureMode::manual;
    settings.exposure_ev100 = static_cast<float>(render::ev100_of_exposure(static_cast<double>(exposure)));
    settings.exposure_compensation = 0;
    return render::RadiancePicture(radiance, coverage, size).display(settings);
}

// The level as it stands. `whole`: as its own camera sees it, not the player.
double still(Playthrough& level, const Wanted& wanted, bool whole, const std::string& name) {
    look_with_eyes(level.shown());
    level.app().show();  // its space is known from the first frame on
    for (int i = 0; i < kSettling; ++i) {
        if (whole) {
            look_from_title(level.shown(), 0);
        }
        level.app().show();
    }
    const render::FrameRenderer& renderer = *level.world().resource<Renderer>().frame;
    const ImageF shown = renderer.read(render::Aov::final);
    std::vector<std::vector<float>> radiance;
    std::vector<float> coverage;
    for (int b = 0; b < wanted.batches; ++b) {
        reference::PathSettings path;
        path.spp = wanted.spp;
        path.transport = reference::Transport::full;
        path.unlimited = true;
        path.seed = static_cast<std::uint32_t>(b + 1);
        reference::PathTracer tracer(level.world().resource<FrameScene>(), wanted.size, path,
                                     {.radiance = true});
        tracer.render({});
        radiance.push_back(tracer.image(reference::PathAov::radiance));
        coverage = tracer.coverage();
    }
    const auto reference = [&](std::span<const std::vector<float>> of) {
        return displayed(median(of), coverage, wanted.size, level.world().resource<render::RenderSettings>(),
                         renderer.exposure());
    };
    const std::span<const std::vector<float>> all(radiance);
    const ImageF truth = reference(all);
    const double error = mean(workbench::flip(shown, truth));
    const double noise =
        mean(workbench::flip(reference(all.first(all.size() / 2)), reference(all.last(all.size() / 2))));
    std::filesystem::create_directories("stills");
    write_image(fmt::format("stills/{}.png", name), shown);
    write_image(fmt::format("stills/{}-path.png", name), truth);
    fmt::print("{:<16} FLIP {:.3f}; two halves of the reference {:.3f}\n", name, error, noise);
    std::fflush(stdout);
    return error;
}

std::vector<double> stills(const std::string& stem, const Wanted& wanted) {
    Options options;
    options.headless = true;
    options.level = support::repository_file("assets/levels/" + stem + ".glb");
    options.replay = support::repository_file("tests/replay/" + stem + ".rec");
    Playthrough level(options, import_gltf(options.level));
    Quality(options, level.session().seed()).draw(level.app(), {"medium"});
    level.app().view().size = wanted.size;
    const std::uint64_t toured = *level.session().length();
    const auto play = [&](std::uint64_t until) {
        while (level.session().steps() < until) {
            level.app().step();
        }
    };
    std::vector<double> errors{still(level, wanted, true, stem + "-1")};
    play(toured / 2);
    errors.push_back(still(level, wanted, false, stem + "-2"));
    play(toured + kAfterwards);
    errors.push_back(still(level, wanted, true, stem + "-3"));
    return errors;
}

}  // namespace
}  // namespace lanthorn::game

int main(int argc, char** argv) {
    using namespace lanthorn;
    const game::LevelBench bench{"bench_stills", "WIDTH HEIGHT BATCHES SPP"};
    return bench.run(argc, argv,
                     [&](const std::vector<std::string>& words, const std::vector<std::string>& levels) {
                         const game::Wanted wanted{{bench.number(words[0]), bench.number(words[1])},
                                                   bench.number(words[2], 2),
                                                   bench.number(words[3])};
                         std::vector<double> errors;
                         for (const std::string& stem : levels) {
                             std::ranges::copy(game::stills(stem, wanted), std::back_inserter(errors));
                         }
                         fmt::print("mean {:.3f}, worst {:.3f} of {} stills\n", game::mean(errors),
                                    std::ranges::max(errors), errors.size());
                     });
}
