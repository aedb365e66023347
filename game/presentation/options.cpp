#include "game/presentation/options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "engine/manual/manual_options.h"
#include "game/level/asset_path.h"
#include "game/presentation/control_words.h"
#include "lanthorn/core/choice.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/core/settings_schema.h"

namespace lanthorn::game {

namespace {

// Of the manual page, beside the options.
manual::PageText page_text() {
    manual::PageText text;
    text.version = LANTHORN_VERSION;
    text.section = 6;
    text.description = {
        "lamplighter is the sample game of Lanthorn, an engine whose lighting is never baked. Crystals wake "
        "where enough light of "
        "their colour arrives, from a lantern that is carried, through doors that are opened, off walls that "
        "colour it.",
        "Keys, mouse and gamepad: " + control_sentence() + ". The menu is where they are chosen.",
        "Without a display it can still record, replay and render what it plays: --headless, --tour."};
    text.exit_codes = {
        {"0", "Done."},
        {"1", "A replay differs from its recording."},
        {"2", "Bad usage or bad input: one line on standard error says what was expected, and where."},
        {"3", "There is no usable OpenGL 4.5."},
        {"130, 143", "Stopped by SIGINT, by SIGTERM; what was done until then is kept."}};
    text.environment = {
        {"LANTHORN_ASSETS", "Folder with lantern-room.glb and levels/, instead of the installation's."},
        {"LANTHORN_SHADERS", "Folder of shaders, instead of the installation's."},
        {"LIBGL_ALWAYS_SOFTWARE", "1 renders on the CPU, by Mesa's llvmpipe."}};
    text.files = {{"~/.config/lamplighter/", "Options and keys; below $XDG_CONFIG_HOME where that is set."},
                  {"~/.local/share/lamplighter/", "Progress; below $XDG_DATA_HOME where that is set."},
                  {"~/.cache/lamplighter/programs",
                   "Which levels are prepared (--prepare); below $XDG_CACHE_HOME where that is set."}};
    text.examples = {
        {"lamplighter --record evening.rec", "Play, and record the session:"},
        {"lamplighter --headless --replay evening.rec", "Check that it plays the same once more:"},
        {"lamplighter --headless --frames 12 --out pictures", "Twelve pictures of a scripted tour:"}};
    text.see_also = {"lanthorn(1)"};
    return text;
}

manual::Values option_values() {
    return {{"--preset", preset_names()}, {"--set", {}}, {"--size", {}}, {"--seed", {}}};
}

}  // namespace

std::optional<Options> parse_options(int argc, const char* const* argv) {
    Options options;
    options.level = asset_path("lantern-room.glb");
    std::string size, seed;
    CLI::App app{
        "lamplighter: levels in which light, carried, coloured and bounced, wakes crystals.\n"
        "Keys, mouse and gamepad, which the menu can change:\n" +
            control_lines(),
        "lamplighter"};
    const CLI::Option* level =
        app.add_option("--level", options.level, "glTF scene to play in, without title and progress")
            ->default_str("lantern-room.glb");
    app.add_option("--record", options.record, "write the session into this file");
    app.add_option("--replay", options.replay,
                   "play this recording and check every step; exit code 1 if one differs");
    app.add_flag("--headless", options.headless, "no window: a scripted tour, or the replay");
    app.add_flag("--tour", options.tour,
                 "all levels, or the one of --level, play themselves: in a window, or without a display and "
                 "--headless into --out: stills, tour.webp and index.html");
    app.add_flag("--prepare", options.prepare,
                 "have OpenGL compile what pictures of all levels need, or of the one of --level, into its "
                 "cache, and end: no start waits for it");
    app.add_option("--frames", options.frames,
                   "pictures to make, headless; any number: between two steps they are interpolated")
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--out", options.out, "folder for the pictures; without it none are made");
    app.add_option(
        "--size", size,
        "of the picture: WIDTHxHEIGHT; default 1280x720, or where OpenGL runs on the CPU 640x360, drawn "
        "smaller in a window as frames take more than 125 ms");
    app.add_option("--preset", options.preset,
                   "low, medium, high or ultra; paper: the technique as it was published");
    app.add_option("--set", options.set, "a setting: KEY=VALUE; may be repeated")->allow_extra_args(false);
    app.add_option("--seed", seed, "of the simulation and the photons; default 1");
    app.add_option("--threads", options.threads, "of the simulation; 0: all")->check(CLI::Range(0, 1024));
    app.add_flag("--print-schedule", options.print_schedule, "print both schedules in DOT and end");
    app.add_option(
        "--log", options.log,
        "append to this file how the window runs, a line of JSON a second: frame times, and what is held");
    app.add_flag("--escape-leaves", options.escape_leaves,
                 "Esc ends the game instead of opening its menu: for an editor that is behind it");
    app.add_option("--close-after", options.close_after, "close the window after this many frames")
        ->check(CLI::Range(1, 1'000'000));
    manual::add_manual_options(app, page_text, option_values);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        return std::nullopt;
    } catch (const CLI::CallForVersion& asked) {
        std::cout << asked.what();
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
    if (options.prepare &&
        (options.headless || options.tour || !options.record.empty() || !options.replay.empty())) {
        throw InputError("usage: --prepare excludes --headless, --tour, --record and --replay");
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
