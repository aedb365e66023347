// lamplighter, the sample game.
#include <cstdio>
#include <exception>
#include <optional>

#include "game/headless.h"
#include "game/options.h"
#include "game/simulation.h"
#include "game/windowed.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"

namespace {

using namespace lanthorn;

ExitCode run(int argc, char** argv) {
    const std::optional<game::Options> options = game::parse_options(argc, argv);
    if (!options) {
        return ExitCode::ok;
    }
    const SceneData scene = import_gltf(options->level);
    for (const std::string& warning : scene.warnings) {
        std::fprintf(stderr, "%s: %s\n", options->level.c_str(), warning.c_str());
    }
    const game::Level level = game::find_level(scene);
    if (options->print_schedule) {
        std::fputs(game::Simulation(level, options->seed, options->threads).schedule_dot().c_str(), stdout);
        return ExitCode::ok;
    }
    return options->headless ? game::run_headless(*options, scene, level)
                             : game::run_windowed(*options, scene, level);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return static_cast<int>(run(argc, argv));
    } catch (const lanthorn::Error& e) {
        std::fprintf(stderr, "lamplighter: %s\n", e.what());
        return static_cast<int>(e.code());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "lamplighter: %s\n", e.what());
        return static_cast<int>(lanthorn::ExitCode::check_failed);
    }
}
