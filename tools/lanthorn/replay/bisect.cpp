// lanthorn replay bisect FILE: where a replay parts from its recording, down to the field.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/world_hash.h"
#include "tools/lanthorn/replay/cause.h"
#include "tools/lanthorn/replay/commit_search.h"
#include "tools/lanthorn/replay/replay_commands.h"

namespace lanthorn::tools {

namespace {

struct BisectOptions {
    std::string file, level, against;
    CommitChoice commits{
        .range = "",
        .repository = ".",
        .build = "cmake --preset release >/dev/null && cmake --build build/release --target lanthorn",
        .program = "build/release/tools/lanthorn/lanthorn",
        .file = "",
        .level = ""};
    bool all = false;
    bool json = false;
};

constexpr std::array kThreads = {1, 2, 1};  // of the runs
constexpr std::size_t kShown = 3;           // fields, without --all
constexpr std::size_t kMost = 1000;

// What one run comes to: where it first differs, and its state there.
struct Run {
    std::optional<replay::Divergence> first;
    std::vector<std::uint64_t> hashes;

    bool like(const Run& other) const {
        return first.has_value() == other.first.has_value() &&
               (!first || (first->step == other.first->step && hashes == other.hashes));
    }
};

Run run(const LevelFile& level, const std::string& file,
        const std::shared_ptr<const replay::Recording>& recording, int threads) {
    ReplayedLevel replayed(level, file, recording, {.threads = threads});
    while (!replayed.session().done() && replayed.comparison().divergences.empty()) {
        replayed.app().step();
    }
    Run result;
    if (!replayed.comparison().divergences.empty()) {
        result.first = replayed.comparison().divergences.front();
        result.hashes = ecs::state_hashes(replayed.app().registry(), replayed.world());
    }
    return result;
}

// Two runs of this build that part, step by step beside each other.
std::optional<Cause> by_chance(const LevelFile& level, const std::string& file,
                               const std::shared_ptr<const replay::Recording>& recording) {
    for (int attempt = 0; attempt < 3; ++attempt) {
        ReplayedLevel one(level, file, recording, {.threads = 1}),
            two(level, file, recording, {.threads = 2});
        const ecs::Registry& registry = one.app().registry();
        const std::vector<std::string> parts = ecs::state_parts(registry);
        while (!one.session().done()) {
            one.app().step();
            two.app().step();
            const auto a = ecs::state_hashes(registry, two.world()),
                       b = ecs::state_hashes(registry, one.world());
            if (a == b) {
                continue;
            }
            Cause cause;
            cause.step = one.session().steps() - 1;
            for (std::size_t i = 0; i < parts.size(); ++i) {
                if (a[i] != b[i]) {
                    cause.parts.push_back(parts[i]);
                }
            }
            cause.fields = field_differences(registry, two.world(), one.world(), kMost);
            return cause;
        }
    }
    return std::nullopt;
}

// The next state in the file, for want of a better one: later, and what differs there may have spread.
std::optional<Cause> by_stored_state(const LevelFile& level, const std::string& file,
                                     const std::shared_ptr<const replay::Recording>& recording,
                                     std::uint64_t step) {
    for (const replay::StoredState& stored : recording->annotations.states) {
        if (stored.step <= step || stored.step > recording->steps.size()) {
            continue;
        }
        ReplayedLevel here(level, file, recording), there(level, file, recording);
        while (here.session().steps() < stored.step) {
            here.app().step();
        }
        const ecs::Registry& registry = there.app().registry();
        ecs::Snapshot::from_bytes(stored.bytes, registry, file).restore(there.app().world());
        Cause cause;
        cause.step = stored.step;
        cause.fields = field_differences(registry, here.world(), there.world(), kMost);
        return cause;
    }
    return std::nullopt;
}

// The systems that change a part that differs, in the step that does: one of them is it.
std::vector<std::string> suspects(const LevelFile& level, const std::string& file,
                                  const std::shared_ptr<const replay::Recording>& recording,
                                  const replay::Divergence& first) {
    ReplayedLevel replayed(level, file, recording);
    while (replayed.session().steps() < first.step) {
        replayed.app().step();
    }
    std::vector<std::uint64_t> before = ecs::state_hashes(replayed.app().registry(), replayed.world());
    const TracedStep trace = trace_step(replayed, first.step, "");
    std::vector<std::string> systems;
    for (const SystemState& state : trace.systems) {
        for (std::size_t i = 0; i < trace.parts.size(); ++i) {
            if (state.hashes[i] != before[i] &&
                std::ranges::find(first.parts, trace.parts[i]) != first.parts.end()) {
                systems.push_back(state.system);
                break;
            }
        }
        before = state.hashes;
    }
    return systems;
}

struct Found {
    std::string repeats;
    std::optional<replay::Divergence> first;
    std::optional<Cause> cause;
    std::string other;  // what the cause was held against
    std::string open;   // the command that shows both; empty: there is no other world to show
    std::vector<std::string> suspects;
};

Found find(const BisectOptions& options) {
    const auto recording = std::make_shared<const replay::Recording>(replay::read_recording(options.file));
    const auto level = read_level(options.file, recording->header, options.level);
    std::vector<Run> runs;
    runs.reserve(std::size(kThreads));
    for (const int threads : kThreads) {
        runs.push_back(run(*level, options.file, recording, threads));
    }
    Found found;
    const auto differing = std::ranges::find_if(runs, [](const Run& r) { return r.first.has_value(); });
    const bool alike = std::ranges::all_of(runs, [&](const Run& r) { return r.like(runs[0]); });
    const auto count = std::ranges::count_if(runs, [](const Run& r) { return r.first.has_value(); });
    if (differing == runs.end()) {
        found.repeats =
            fmt::format("{} of {} runs, 1 and 2 threads, are equal to the recording: nothing to find",
                        runs.size(), runs.size());
        return found;
    }
    found.first = differing->first;
    if (!alike) {
        found.repeats =
            fmt::format("{} of {} runs, 1 and 2 threads, differ, and not alike: chance, not a change", count,
                        runs.size());
        found.cause = by_chance(*level, options.file, recording);
        found.other = "a run of this build with 2 threads (found) against one with 1 (expected)";
        return found;
    }
    found.repeats = fmt::format("{} of {} runs, 1 and 2 threads, differ alike: a change of code, not chance",
                                count, runs.size());
    if (!options.against.empty()) {
        const auto reference = program_reference(options.against, level->path);
        found.cause = find_cause(*level, *recording, found.first->step, {}, *reference, kMost);
        found.other = options.against;
        found.open = fmt::format("lanthorn edit {} --at {}:{} --beside --against {}", level->path,
                                 options.file, found.first->step + 1, options.against);
    } else {
        found.cause = by_stored_state(*level, options.file, recording, found.first->step);
        found.other = "the state in the file";
        found.open = found.cause ? fmt::format("lanthorn edit {} --at {}:{} --beside", level->path,
                                               options.file, found.cause->step)
                                 : "";
    }
    if (!found.cause || found.cause->system.empty()) {
        found.suspects = suspects(*level, options.file, recording, *found.first);
    }
    return found;
}

void print_fields(const Cause& cause, bool all) {
    std::string entity;
    const std::size_t shown = all ? cause.fields.size() : std::min(kShown, cause.fields.size());
    for (std::size_t i = 0; i < shown; ++i) {
        const FieldDifference& d = cause.fields[i];
        if (i == 0 || d.entity != entity) {
            entity = d.entity;
            fmt::print("entity    {}\n", entity.empty() ? "none: a resource" : entity);
        }
        fmt::print("field     {:<28} expected {}\n          {:<28} found    {}{}\n", d.name(), d.expected, "",
                   d.found, d.ulps > 0 ? fmt::format(", {} ulp{}", d.ulps, d.ulps == 1 ? "" : "s") : "");
    }
    if (shown < cause.fields.size()) {
        fmt::print("          {} more fields{}\n", cause.fields.size() - shown, all ? "" : " (--all)");
    }
}

void print(const Found& found, const BisectOptions& options, double step_rate) {
    fmt::print("repeats   {}\n", found.repeats);
    if (!found.first) {
        return;
    }
    const std::uint64_t step = found.first->step;
    fmt::print("step      {} ({:.3f} s){}\n", step, static_cast<double>(step) / step_rate,
               step > 0 ? fmt::format("; equal after {}", step - 1) : "");
    fmt::print("part      {}\n", found.first->parts.empty()
                                     ? "one whose tag is the same"
                                     : fmt::format("{}", fmt::join(found.first->parts, ", ")));
    if (found.cause && !found.cause->system.empty()) {
        fmt::print("system    {} ({} of {} fixed systems): equal before it, different after it\n",
                   found.cause->system, found.cause->position, found.cause->systems);
    } else if (!found.suspects.empty()) {
        fmt::print("system    one of those that change it in this step: {}\n",
                   fmt::join(found.suspects, ", "));
    }
    if (found.cause) {
        if (found.cause->step != step) {
            fmt::print("later     fields as they are after step {}, where {} is: it may have spread\n",
                       found.cause->step, found.other);
        }
        print_fields(*found.cause, options.all);
        if (!found.open.empty()) {
            fmt::print("open      {}\n", found.open);
        }
    } else {
        fmt::print(
            "field     not known without another state; --against PROGRAM, the build that recorded it, "
            "tells\n");
    }
}

nlohmann::ordered_json json_of(const Found& found) {
    nlohmann::ordered_json json{{"repeats", found.repeats}, {"equal", !found.first}};
    if (!found.first) {
        return json;
    }
    json["step"] = found.first->step;
    json["parts"] = found.first->parts;
    json["system"] = found.cause ? found.cause->system : "";
    json["suspects"] = found.suspects;
    json["against"] = found.cause ? found.other : "";
    json["open"] = found.open;
    json["fields"] = nlohmann::ordered_json::array();
    if (found.cause) {
        json["fields_at_step"] = found.cause->step;
        for (const FieldDifference& d : found.cause->fields) {
            json["fields"].push_back({{"entity", d.entity},
                                      {"field", d.name()},
                                      {"expected", d.expected},
                                      {"found", d.found},
                                      {"ulps", d.ulps},
                                      {"sign", d.sign}});
        }
    }
    return json;
}

FoundCommit commit_of(const BisectOptions& options) {
    CommitChoice choice = options.commits;
    choice.file = std::filesystem::absolute(options.file).string();
    const replay::Recording recording = replay::read_recording(options.file);
    choice.level =
        std::filesystem::absolute(read_level(options.file, recording.header, options.level)->path).string();
    return find_commit(
        choice, [](const std::string& line) { std::fprintf(stderr, "%s\n", printable(line).c_str()); });
}

void print(const FoundCommit& commit) {
    fmt::print("commit    {} \"{}\" ({} of {} built)\n", commit.hash, commit.title, commit.built,
               commit.commits);
    for (const std::string& other : commit.perhaps) {
        fmt::print("          or {}, which could not be tested\n", other);
    }
}

ExitCode bisect(const BisectOptions& options) {
    const Found found = find(options);
    std::optional<FoundCommit> commit;
    const StopSignal stop;
    if (!options.commits.range.empty()) {
        commit = commit_of(options);
    }
    if (options.json) {
        nlohmann::ordered_json json = json_of(found);
        if (commit) {
            json["commit"] = {{"hash", commit->hash}, {"title", commit->title}, {"perhaps", commit->perhaps}};
        }
        fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    } else {
        print(found, options, 60);
        if (commit) {
            print(*commit);
        }
    }
    return found.first ? ExitCode::check_failed : ExitCode::ok;
}

}  // namespace

Command add_replay_bisect(CLI::App& replay) {
    auto options = std::make_shared<BisectOptions>();
    CLI::App* command = replay.add_subcommand(
        "bisect", "Where a replay parts from its recording: step, part, system, entity, field, both values.");
    command->add_option("FILE", options->file, "a recording (.rec)")->required();
    command->add_option("--level", options->level, "the level's file; default: as verify finds it")
        ->type_name("FILE");
    command
        ->add_option("--against", options->against,
                     "another build of lanthorn, that which recorded it, say: tells the expected values")
        ->type_name("PROGRAM");
    command->add_option("--commits", options->commits.range,
                        "GOOD..BAD: builds commits between them until the first is found that differs");
    command->add_option("--repository", options->commits.repository, "of --commits")
        ->type_name("DIR")
        ->capture_default_str();
    command->add_option("--build", options->commits.build, "of --commits: a shell command, in a checkout")
        ->type_name("COMMAND")
        ->capture_default_str();
    command
        ->add_option("--program", options->commits.program,
                     "of --commits: what it builds, with `replay verify`")
        ->type_name("PATH")
        ->capture_default_str();
    command->add_flag("--all", options->all, "print all fields that differ");
    command->add_flag("--json", options->json, "print one JSON object");
    return [options] { return bisect(*options); };
}

}  // namespace lanthorn::tools
