// `lanthorn replay accept`: a known difference, by name, with a reason and a day; or what a mark's picture is
// from now on.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>

#include "lanthorn/core/choice.h"
#include "tools/lanthorn/replay/pictures/picture_check.h"
#include "tools/lanthorn/replay/replay_commands.h"
#include "tools/replay_suite/accepted.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;

constexpr int kMostPixels = 4096;  // a side of a baseline

struct AcceptOptions {
    suite::Acceptance acceptance;
    std::string folder, today, level, size, preset;
    std::optional<int> frames;
    bool picture_alone = false;
};

fs::path recording_file(const AcceptOptions& options, const std::string& name) {
    fs::path file = fs::path(options.folder) / name;
    if (!fs::is_regular_file(file)) {
        throw InputError(options.folder, "",
                         "found no recording '" + name +
                             "', expected a failure as the suite names it (pool.rec-1a2b3c), or a mark "
                             "(pool.rec:door-open)");
    }
    return file;
}

// "pool.rec:door-open": its picture becomes the baseline.
ExitCode accept_picture(const AcceptOptions& options, const std::string& today) {
    const std::string& name = options.acceptance.failure;
    const std::size_t colon = name.find(':');
    const std::string file = recording_file(options, name.substr(0, colon)).string();
    const std::string mark = name.substr(colon + 1);
    const auto recording = std::make_shared<const replay::Recording>(replay::read_recording(file));
    const auto level = read_level(file, recording->header, options.level);
    const std::optional<Baseline> before = read_baseline(file, mark);
    MarkView view = before ? before->view : MarkView();
    if (!options.size.empty()) {
        view.size = parse_size("--size", options.size, 1, kMostPixels);
    }
    view.frames = options.frames.value_or(view.frames);
    if (!options.preset.empty()) {
        view.preset = options.preset;
    }
    make_baselines(level, file, recording, {mark}, view, options.acceptance.reason, today,
                   !options.picture_alone);
    fmt::print("{}: {}\n", baseline_file(file, mark).string(), before ? "replaced" : "made");
    return ExitCode::ok;
}

ExitCode accept(const AcceptOptions& options) {
    const std::string today = options.today.empty() ? suite::today() : options.today;
    if (options.acceptance.reason.find_first_not_of(" \t") == std::string::npos) {
        throw InputError("--reason: found nothing, expected why the difference is right");
    }
    if (options.acceptance.failure.find(':') != std::string::npos) {
        if (!options.acceptance.until.empty()) {
            throw InputError("--until: found with a picture, which is accepted for good");
        }
        return accept_picture(options, today);
    }
    if (options.acceptance.until.empty()) {
        throw InputError(
            "--until: not given, expected the last day on which it is accepted, as in 2026-12-31");
    }
    recording_file(options, suite::recording_of(options.acceptance.failure));
    suite::accept(options.folder, options.acceptance, today);
    return ExitCode::ok;
}

}  // namespace

Command add_replay_accept(CLI::App& app) {
    auto options = std::make_shared<AcceptOptions>();
    CLI::App* command = app.add_subcommand(
        "accept",
        "Accept a failure that a suite reported, for a reason and until a day; or a mark's picture.");
    command
        ->add_option("FAILURE", options->acceptance.failure,
                     "as the suite names it: pool.rec-1a2b3c; or a mark whose picture, as it is now, becomes "
                     "the expected one: pool.rec:door-open")
        ->required();
    command->add_option("--suite", options->folder, "folder of the recordings")->required();
    command->add_option("--reason", options->acceptance.reason, "why the difference is right")->required();
    command->add_option("--until", options->acceptance.until,
                        "last day on which a failure is accepted: 2026-12-31");
    command
        ->add_option("--level", options->level, "of a picture: the level's file; default: as verify finds it")
        ->type_name("FILE");
    command->add_option("--size", options->size, "of a picture: WIDTHxHEIGHT; default: as before, 320x180");
    command->add_option("--frames", options->frames, "of a picture: frames from cold; default: as before, 12")
        ->check(CLI::Range(1, 10'000));
    command->add_option("--preset", options->preset, "of a picture's settings; default: as before, medium");
    command->add_flag("--picture-alone", options->picture_alone,
                      "of a picture: without the error of light there, which takes most of the time; verify "
                      "--light then fails");
    command->add_option("--today", options->today)->group("");
    return [options] { return accept(*options); };
}

}  // namespace lanthorn::tools
