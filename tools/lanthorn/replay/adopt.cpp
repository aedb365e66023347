// lanthorn replay adopt FILE: makes a test of a session that went wrong, as short as still goes wrong alike.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>

#include "engine/core/crash_report.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"
#include "tools/lanthorn/common/child_process.h"
#include "tools/lanthorn/replay/minimise.h"
#include "tools/lanthorn/replay/reduce_steps.h"
#include "tools/lanthorn/replay/replay_commands.h"
#include "tools/replay_suite/crash_text.h"
#include "tools/replay_suite/files.h"
#include "tools/replay_suite/limited_child.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double kLongestTrial = 300;  // seconds

struct AdoptOptions {
    std::string file, suite, name, level, against, mutant;
    double seconds = 60;
    bool whole = false;
};

// What became of a replay in a process of its own.
struct Fate {
    int signal = 0;          // that ended it; 0: none
    std::uint64_t step = 0;  // done before the signal
    std::string frame;       // the innermost of the stack behind the handler, as an offset in its file
    int code = 0;            // exit code, without a signal
    std::string error;       // last line of standard error

    bool same_as(const Fate& other) const { return signal == other.signal && frame == other.frame; }
};

// "signal 11", "step 377", then a frame a line, of which the first two are the handler's:
// "lanthorn(+0x1a2b3c) [0x55d0]". Offsets are the same in every run, addresses are not.
void read_report(const std::string& report, Fate& fate) {
    std::size_t line = 0;
    for (std::size_t at = 0; at < report.size(); ++line) {
        const std::size_t end = std::min(report.find('\n', at), report.size());
        const std::string text = report.substr(at, end - at);
        at = end + 1;
        if (line == 1 && text.starts_with("step ")) {
            fate.step = std::strtoull(text.c_str() + 5, nullptr, 10);
        } else if (line == 4) {
            const std::size_t open = text.find('(');
            fate.frame = open == std::string::npos ? text : text.substr(0, text.find(')', open) + 1);
        }
    }
}

class Adoption {
  public:
    explicit Adoption(const AdoptOptions& options)
        : options_(options),
          recording_(replay::read_recording(options.file)),
          level_(read_level(options.file, recording_.header, options.level)) {}

    ExitCode run() {
        const fs::path out = target();
        const Fate fate = play(options_.file);
        if (fate.signal != 0) {
            adopt_crash(fate);
        } else if (fate.code == 1 && !options_.against.empty() && !options_.whole) {
            adopt_divergence();
        } else if (fate.code == 1) {
            shows_ = "a difference: `lanthorn replay bisect` says which";
        } else if (fate.code != 0) {
            throw InputError(fate.error.empty() ? options_.file + ": cannot be played" : fate.error);
        }
        recording_.cut_off.clear();
        recording_.annotations.notes.push_back(
            fmt::format("adopted from {}: {}", fs::path(options_.file).filename().string(), shows_));
        replay::write_recording(out.string(), recording_);
        bring_level(out);
        fmt::print(
            "adopted   {}: {} steps ({:.1f} s), {} presses (of {} steps, {} presses), {} trials in {:.1f} "
            "s\n",
            out.string(), recording_.steps.size(),
            static_cast<double>(recording_.steps.size()) / recording_.header.step_rate,
            presses(recording_.steps), before_.steps, before_.presses, trials_,
            std::chrono::duration<double>(Clock::now() - start_).count());
        fmt::print("shows     {}\n", shows_);
        fmt::print("next      lanthorn replay verify {}\n", out.string());
        return ExitCode::ok;
    }

  private:
    fs::path target() const {
        const std::string name =
            options_.name.empty() ? fs::path(options_.file).stem().string() : options_.name;
        if (name.find('/') != std::string::npos) {
            throw InputError(fmt::format("--name: found '{}', expected a name without folders", name));
        }
        if (!fs::is_directory(options_.suite)) {
            throw InputError(options_.suite, "", "not there, expected the folder of a suite's recordings");
        }
        fs::path out = fs::path(options_.suite) / (name + ".rec");
        if (fs::exists(out)) {
            throw InputError(out.string(), "", "is there already, expected --name of one that is not");
        }
        return out;
    }

    Fate play(const std::string& file) {
        ++trials_;
        const fs::path report = scratch_.at("crash");
        std::error_code ignored;
        fs::remove(report, ignored);
        std::vector<std::string> command = {own_executable(), "replay",    "verify", file,
                                            "--level",        level_->path};
        if (!options_.mutant.empty()) {
            command.insert(command.end(), {"--mutant", options_.mutant});
        }
        const suite::ChildRun child =
            suite::run_limited(command, {fmt::format("{}={}", kCrashFileVariable, report.string())},
                               {.seconds = kLongestTrial, .stuck_seconds = kLongestTrial, .memory_mib = 0},
                               scratch_.at("progress"), [] { return StopSignal::asked(); });
        Fate fate;
        fate.code = child.code;
        std::string error = child.err;
        error.erase(error.find_last_not_of(" \r\n") + 1);
        fate.error = error.substr(error.find_last_of('\n') + 1);
        switch (child.end) {
            case suite::ChildRun::End::exited:
                return fate;
            case suite::ChildRun::End::signalled:
                fate.signal = child.signal;
                read_report(suite::read_if_there(report), fate);
                return fate;
            case suite::ChildRun::End::stopped:
                throw InputError("replay adopt: stopped");
            default:
                throw InputError(
                    file, "",
                    fmt::format("was not played in {} s, expected an end or a crash", kLongestTrial));
        }
    }

    void adopt_crash(const Fate& fate) {
        std::error_code error;
        const fs::path program = fs::read_symlink("/proc/self/exe", error);  // as the stack calls it
        const std::optional<suite::Crash> told = suite::read_crash(scratch_.at("crash"), program.string());
        shows_ = fmt::format("{} after step {}", suite::signal_words(fate.signal), fate.step);
        recording_.annotations.states.clear();
        std::vector<replay::RecordedStep> steps = recording_.steps;
        steps.resize(std::min<std::size_t>(steps.size(), fate.step + 1));
        const auto shows =
            [&](std::vector<replay::RecordedStep> trial) -> std::optional<std::vector<replay::RecordedStep>> {
            replay::Recording all = recording_;
            all.annotations.marks.clear();
            all.steps = trial;
            replay::write_recording(scratch_.at("trial.rec").string(), all);
            const Fate now = play(scratch_.at("trial.rec").string());
            if (!now.same_as(fate)) {
                return std::nullopt;
            }
            trial.resize(std::min<std::size_t>(trial.size(), now.step + 1));
            return trial;
        };
        if (!options_.whole) {
            steps = reduce_steps(std::move(steps), shows, options_.seconds).steps;
        }
        // The states up to the last step, which nobody has lived to see.
        replay::RecordedStep last = std::move(steps.back());
        steps.pop_back();
        last.root = 0;
        last.changed.clear();
        recording_.steps = std::move(steps);
        recording_ = played_again(*level_, recording_, {});
        recording_.steps.push_back(std::move(last));
        const auto behind = [&](const replay::Mark& mark) { return mark.step >= recording_.steps.size(); };
        std::erase_if(recording_.annotations.marks, behind);
        shows_ =
            fmt::format("{} after step {}", suite::signal_words(fate.signal), recording_.steps.size() - 1);
        if (told && !told->where().empty()) {
            shows_ += ", in " + told->where();
        }
    }

    void adopt_divergence() {
        const auto reference = program_reference(options_.against, level_->path);
        const Minimised minimised = minimise(*level_, recording_, *reference, {.seconds = options_.seconds});
        recording_ = minimised.recording;
        trials_ += minimised.trials;
        shows_ =
            fmt::format("step {}, {}, {}", minimised.cause.step, minimised.cause.system,
                        minimised.cause.fields.empty() ? "entities" : minimised.cause.fields.front().name());
    }

    // The suite looks for levels beside its recordings and among the project's own.
    void bring_level(const fs::path& out) const {
        try {
            if (fs::exists(level_of(out.string(), recording_.header))) {
                return;
            }
        } catch (const InputError&) {
        }
        std::error_code error;
        fs::copy_file(level_->path, out.parent_path() / recording_.header.level, error);
        if (error) {
            throw InputError(level_->path, "", "cannot be copied beside the recording: " + error.message());
        }
    }

    const AdoptOptions& options_;
    const Clock::time_point start_ = Clock::now();
    const suite::Scratch scratch_ = suite::Scratch::temporary("lanthorn-adopt");
    replay::Recording recording_;
    std::shared_ptr<const LevelFile> level_;
    struct {
        std::size_t steps, presses;
    } before_{recording_.steps.size(), presses(recording_.steps)};
    std::string shows_ = "no fault in this build";
    int trials_ = 0;
};

}  // namespace

Command add_replay_adopt(CLI::App& replay) {
    auto options = std::make_shared<AdoptOptions>();
    CLI::App* command = replay.add_subcommand(
        "adopt", "Makes a test of a session that crashed or differs, as short as still shows it.");
    command->add_option("FILE", options->file, "a recording (.rec), cut off or whole")->required();
    command->add_option("--suite", options->suite, "folder of recordings that it joins")->required();
    command->add_option("--name", options->name, "of the new recording; default: FILE's");
    command
        ->add_option("--against", options->against,
                     "the build that plays it right, to make one that differs short")
        ->type_name("PROGRAM");
    command->add_flag("--whole", options->whole, "leave out nothing before the fault");
    command->add_option("--seconds", options->seconds, "after which it is short enough")
        ->check(CLI::Range(1.0, 86400.0))
        ->capture_default_str();
    command->add_option("--level", options->level, "the level's file; default: as verify finds it")
        ->type_name("FILE");
    command->add_option("--mutant", options->mutant)->group("");
    return [options] {
        const StopSignal stop;
        return Adoption(*options).run();
    };
}

}  // namespace lanthorn::tools
