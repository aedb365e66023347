// lanthorn replay play FILE: in the game's window; or without a picture, from one step to another.
// lanthorn replay record LEVEL: a session of the game.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>

#include "lanthorn/core/error.h"
#include "tools/lanthorn/common/game_program.h"
#include "tools/lanthorn/replay/judge.h"
#include "tools/lanthorn/replay/replay_commands.h"
#include "tools/lanthorn/replay/seek.h"

namespace lanthorn::tools {

namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct PlayOptions {
    std::string file, level, out;
    std::optional<std::uint64_t> from, to;
    bool window = false;
};

ExitCode play_here(const PlayOptions& options) {
    const auto recording = std::make_shared<const replay::Recording>(replay::read_recording(options.file));
    const auto level = read_level(options.file, recording->header, options.level);
    const std::uint64_t steps = recording->steps.size();
    const std::uint64_t from = options.from.value_or(0), to = options.to.value_or(steps);
    if (from > to || to > steps) {
        throw InputError(options.file, "--from, --to",
                         fmt::format("found {} to {}, expected steps up to {}, the first not behind the last",
                                     from, to, steps));
    }
    ReplayedLevel replayed(*level, options.file, recording);
    const StateCache cache(key_of(options.file, *level));
    const auto start = Clock::now();
    const std::uint64_t begun = seek(replayed, from, cache);
    fmt::print("seek      to step {} ({:.1f} s) in {:.2f} s, from {}\n", from,
               static_cast<double>(from) / recording->header.step_rate, since(start),
               begun > 0 ? fmt::format("the state before key step {}", begun) : "the beginning");
    const auto played = Clock::now();
    seek(replayed, to, cache);
    const replay::Comparison& c = replayed.comparison();
    fmt::print("played    to step {} in {:.2f} s; {} states compared\n", to, since(played), c.steps);
    for (const replay::Divergence& d : c.divergences) {
        fmt::print("differs   {}{}\n", d.describe(),
                   d.last > d.step ? fmt::format(", until step {}", d.last) : "");
    }
    return c.divergences.empty() ? ExitCode::ok : ExitCode::check_failed;
}

ExitCode play(const PlayOptions& options) {
    if (!options.window && options.out.empty()) {
        return play_here(options);
    }
    const replay::Recording recording = replay::read_recording(options.file);
    const std::string level =
        options.level.empty() ? level_of(options.file, recording.header).string() : options.level;
    std::vector<std::string> arguments = {"--level", level, "--replay", options.file};
    if (!options.out.empty()) {
        arguments.insert(arguments.end(), {"--headless", "--out", options.out});
    }
    become_game(std::move(arguments));
}

struct RecordOptions {
    std::string level, out, pictures;
    std::uint64_t seed = 1;
    bool tour = false;
};

ExitCode record(const RecordOptions& options) {
    std::vector<std::string> arguments = {"--level",   options.level, "--record",
                                          options.out, "--seed",      fmt::format("{}", options.seed)};
    if (options.tour) {
        arguments.emplace_back("--headless");
    }
    if (!options.pictures.empty()) {
        arguments.insert(arguments.end(), {"--out", options.pictures});
    }
    become_game(std::move(arguments));
}

}  // namespace

Command add_replay_play(CLI::App& replay) {
    auto options = std::make_shared<PlayOptions>();
    CLI::App* command = replay.add_subcommand(
        "play",
        "Plays a recording: without a picture from one step to another, in the game's window, or as "
        "pictures.");
    command->add_option("FILE", options->file, "a recording (.rec)")->required();
    command->add_option("--from", options->from, "seek there first")->type_name("STEP");
    command->add_option("--to", options->to, "and play to there; default: the end")->type_name("STEP");
    command->add_flag("--window", options->window, "in the game's window, from the beginning");
    command->add_option("--out", options->out, "pictures of it, into this folder")->type_name("DIR");
    command->add_option("--level", options->level, "the level's file; default: as verify finds it")
        ->type_name("FILE");
    return [options] { return play(*options); };
}

Command add_replay_record(CLI::App& replay) {
    auto options = std::make_shared<RecordOptions>();
    CLI::App* command = replay.add_subcommand(
        "record", "Records a session of the game: yours in a window, or a level's tour.");
    command->add_option("LEVEL", options->level, "the level's file (.glb, .gltf)")->required();
    command->add_option("-o,--out", options->out, "recording to write")->required()->type_name("FILE");
    command->add_option("--seed", options->seed, "of random numbers")->capture_default_str();
    command->add_flag("--tour", options->tour, "the level's tour, without a window");
    command
        ->add_option("--pictures", options->pictures,
                     "with --tour: pictures of it, without which light sensors read nothing")
        ->type_name("DIR");
    return [options] { return record(*options); };
}

}  // namespace lanthorn::tools
