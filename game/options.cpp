#include "game/options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "game/asset_path.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {

std::optional<Options> parse_options(int argc, const char* const* argv) {
    Options options;
    options.level = asset_path("lantern-room.glb");
    std::string size, seed;
    CLI::App app{
        "lamplighter: levels in which light, carried, coloured and bounced, wakes crystals.\n"
        "WASD or left stick: walk; mouse or right stick: look; E or A: use; F or X: light the lantern;\n"
        "G or B: pick it up, put it down; H or up: a hint; Esc or Start: menu. Keys are chosen there."};
    const CLI::Option* level =
        app.add_option("--level", options.level, "glTF scene to play in, without title and progress")
            ->capture_default_str();
    app.add_option("--record", options.record, "write the session into this file");
    app.add_option("--replay", options.replay,
                   "play this recording and check every step; exit code 1 if one differs");
    app.add_flag("--headless", options.headless, "no window: a scripted tour, or the replay");
    app.add_flag("--tour", options.tour,
                 "all levels, or the one of --level, play themselves: in a window, or without a display and "
                 "--headless into --out: stills, tour.webp and index.html");
    app.add_option("--frames", options.frames,
                   "pictures to make, headless; any number: between two steps they are interpolated")
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--out", options.out, "folder for the pictures; without it none are made");
    app.add_option("--size", size,
                   "of the picture: WIDTHxHEIGHT; default 1280x720, or 640x360 where OpenGL runs on the CPU");
    app.add_option("--preset", options.preset, "low, medium, high or ultra");
    app.add_option("--set", options.set, "a setting: KEY=VALUE; may be repeated")->allow_extra_args(false);
    app.add_option("--seed", seed, "of the simulation and the photons; default 1");
    app.add_option("--threads", options.threads, "of the simulation; 0: all")->check(CLI::Range(0, 1024));
    app.add_flag("--print-schedule", options.print_schedule, "print both schedules in DOT and end");
    app.add_option(
        "--log", options.log,
        "append to this file how the window runs, a line of JSON a second: frame times, and what is held");
    app.add_option("--close-after", options.close_after, "close the window after this many frames")
        ->check(CLI::Range(1, 1'000'000));
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        return std::nullopt;
    } catch (const CLI::ParseError& e) {
        throw InputError(std::string("usage: ") + e.what());
    }
    options.straight = level->count() > 0 || (options.headless && !options.tour) || !options.record.empty() ||
                       !options.replay.empty();
    if (!size.empty()) {
        options.size = parse_size("--size", size, 16, 8192);
    }
    if (!seed.empty()) {
        options.seed = parse_whole("--seed", seed);
    }
    if (!seed.empty() && !options.replay.empty()) {
        throw InputError("usage: --replay has the recording's seed, expected no --seed");
    }
    if (!options.record.empty() && !options.replay.empty()) {
        throw InputError("usage: --record and --replay exclude each other");
    }
    if (options.tour && (!options.record.empty() || !options.replay.empty() || options.frames != 0)) {
        throw InputError("usage: --tour excludes --record, --replay and --frames");
    }
    if (!options.headless && !options.tour && (!options.out.empty() || options.frames != 0)) {
        throw InputError("usage: --out and --frames go with --headless");
    }
    if (options.frames != 0 && options.out.empty()) {
        throw InputError("usage: --frames needs --out, the folder for the pictures");
    }
    return options;
}

}  // namespace lanthorn::game
