// lamplighter, the sample game.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <optional>
#include <string>

#include "game/presentation/album/tour_album.h"
#include "game/presentation/headless.h"
#include "game/presentation/options.h"
#include "game/presentation/playthrough.h"
#include "game/presentation/prepare.h"
#include "game/presentation/quality.h"
#include "game/presentation/windowed.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/ecs/workers_end.h"

namespace {

using namespace lanthorn;

// What is printed may not arrive: a full disk may be behind standard output.
void check_printed() {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw InputError("standard output", "", std::string("cannot be written: ") + std::strerror(errno));
    }
}

bool has_display() {
    const auto named = [](const char* variable) {
        const char* value = std::getenv(variable);
        return value != nullptr && *value != '\0';
    };
    return named("DISPLAY") || named("WAYLAND_DISPLAY");
}

ExitCode run(int argc, char** argv, const StopSignal& stop) {
    const std::optional<game::Options> options = game::parse_options(argc, argv);
    if (!options) {
        return ExitCode::ok;
    }
    if (options->prepare) {
        return game::run_prepare(*options, stop);
    }
    if (options->tour && (options->headless || !has_display())) {
        return game::run_tour(*options, stop);
    }
    if (!options->headless && !options->print_schedule) {
        return game::run_windowed(*options, stop);
    }
    const SceneData scene = import_gltf(options->level);
    for (const std::string& warning : scene.warnings) {
        std::fprintf(stderr, "lamplighter: warning: %s: %s\n", printable(options->level).c_str(),
                     warning.c_str());
    }
    if (options->print_schedule) {
        game::Playthrough playthrough(*options, scene);
        game::Quality(*options, playthrough.session().seed()).draw(playthrough.app());
        std::fputs(playthrough.app().schedule_dot().c_str(), stdout);
        return ExitCode::ok;
    }
    return game::run_headless(*options, scene, stop);
}

}  // namespace

int main(int argc, char** argv) {
    const ecs::WorkersEndWithMain workers;
    const StopSignal stop;
    try {
        const ExitCode code = run(argc, argv, stop);
        check_printed();
        return code == ExitCode::ok ? stop.exit_code() : static_cast<int>(code);
    } catch (const lanthorn::Error& e) {
        std::fprintf(stderr, "lamplighter: %s\n", e.what());
        return static_cast<int>(e.code());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "lamplighter: %s\n", e.what());
        return static_cast<int>(lanthorn::ExitCode::check_failed);
    }
}
