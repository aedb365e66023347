// lanthorn replay verify FILE...: whether recordings still lead to the states that they led to.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/core/crash_report.h"
#include "engine/ecs/schedule_trial.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/core/progress.h"
#include "tools/lanthorn/replay/judge.h"
#include "tools/lanthorn/replay/mutant.h"
#include "tools/lanthorn/replay/pictures/mark_processes.h"
#include "tools/lanthorn/replay/progress_file.h"
#include "tools/lanthorn/replay/replay_commands.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;

struct VerifyOptions {
    std::vector<std::string> files;
    std::string result, as, progress, mutant, picture_fault;
    std::uint64_t shuffle = 0;  // seed; 0: the usual order
    JudgeChoice judge;
    int jobs = 1;  // marks at a time
    bool json = false, brief = false;
};

PictureChoice picture_choice(const VerifyOptions& options) {
    PictureChoice choice = options.judge.pictures;
    if (!options.picture_fault.empty()) {
        choice.fault = parse_picture_fault(options.picture_fault);
    }
    if (!options.mutant.empty() || options.shuffle != 0) {
        // A strange state is strange to look at, and the same state needs no second look.
        choice.pictures = choice.light = false;
    }
    if (choice.fault && options.brief) {
        choice.light = false;
        choice.out.clear();
    }
    return choice;
}

// Several marks at a time; null where one at a time is enough.
std::unique_ptr<MarkProcesses> begun(const VerifyOptions& options) {
    const PictureChoice choice = picture_choice(options);
    if (options.jobs == 1 || (!choice.pictures && !choice.light)) {
        return nullptr;
    }
    std::vector<std::string> further;
    if (!options.judge.level.empty()) {
        further = {"--level", options.judge.level};
    }
    return std::make_unique<MarkProcesses>(options.jobs, options.files, choice, further);
}

Verdict judged(const std::string& file, const VerifyOptions& options, MarkProcesses* marks) {
    ProgressFile watched(options.progress);
    JudgeChoice choice = options.judge;
    choice.at_step = [&](std::uint64_t step) { watched.update(step); };
    const PictureChoice pictures = picture_choice(options);
    choice.pictures = marks == nullptr ? pictures : PictureChoice();
    ecs::shuffle_schedules(options.shuffle);
    std::shared_ptr<const MutantReport> planted;
    // The step that was altered has been compared by then, and what a strange state leads to is no matter.
    choice.enough = [&](std::uint64_t step) {
        return options.brief && planted && planted->made && step > planted->step;
    };
    choice.extend = [&](App& app) {
        if (!options.mutant.empty()) {
            planted = plant(parse_mutant(options.mutant), app);
        }
    };
    try {
        Verdict verdict = judge(file, choice);
        if (planted) {
            verdict.mutant = *planted;
        }
        if (marks != nullptr) {
            PictureResults found = marks->of(file);
            verdict.pictures = std::move(found.pictures);
            std::ranges::move(found.checks, std::back_inserter(verdict.checks));
        }
        if (pictures.fault && !verdict.pictures.empty()) {
            const PictureVerdict& first = verdict.pictures.front();
            verdict.mutant = {!first.fault.empty(), first.step, {}, first.fault, {}};
        }
        return verdict;
    } catch (const InputError& e) {
        std::fprintf(stderr, "lanthorn: %s\n", printable(e.what()).c_str());
        Verdict verdict;
        verdict.file = file;
        verdict.error = e.what();
        return verdict;
    }
}

std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void check_usage(const VerifyOptions& options) {
    if (!options.as.empty() && (options.files.size() != 1 || options.result.empty())) {
        throw InputError("--as: found without --result or with several files, expected one recording");
    }
    if (options.as.find('/') != std::string::npos) {
        throw InputError(fmt::format("--as: found '{}', expected a name without folders", options.as));
    }
}

ExitCode verify(const VerifyOptions& options) {
    check_usage(options);
    ExitCode code = ExitCode::ok;
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    const std::unique_ptr<MarkProcesses> marks = begun(options);
    for (const std::string& file : options.files) {
        const Verdict verdict = judged(file, options, marks.get());
        const nlohmann::ordered_json json = verdict_json(verdict);
        if (!options.result.empty()) {
            const std::string name = options.as.empty() ? fs::path(file).stem().string() : options.as;
            write_file(fs::path(options.result) / (name + ".json"), json_text(json));
        }
        if (options.json) {
            all.push_back(json);
        } else {
            fmt::print("{}", verdict_text(verdict));
            std::fflush(stdout);
        }
        if (!verdict.error.empty()) {
            code = ExitCode::bad_input;
        } else if (verdict.failed() && code == ExitCode::ok) {
            code = ExitCode::check_failed;
        }
    }
    if (options.json) {
        fmt::print("{}", json_text(all.size() == 1 ? all[0] : all));
    }
    return code;
}

}  // namespace

Command add_replay_verify(CLI::App& replay) {
    auto options = std::make_shared<VerifyOptions>();
    CLI::App* command = replay.add_subcommand(
        "verify", "Plays recordings and compares every state with the recorded one, bit for bit.");
    command->add_option("FILE", options->files, "recordings (.rec)")->required();
    command
        ->add_option("--level", options->judge.level,
                     "the level's file; default: of the recorded name, beside the recording or among the "
                     "levels")
        ->type_name("FILE");
    command->add_option("--threads", options->judge.threads, "of the simulation; 0: all")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str();
    command->add_flag("--sensors", options->judge.sensors,
                      "draw it now and then, so that light sensors read again: needs OpenGL");
    command
        ->add_option("--heavy", options->judge.heavy,
                     "also save, load and go on from the state at every Nth step, into another App")
        ->type_name("N");
    command->add_flag("--pictures", options->judge.pictures.pictures,
                      "compare pictures at its marks with those of its baselines: needs OpenGL");
    command->add_flag("--light", options->judge.pictures.light,
                      "compare the error of indirect light there, against the path tracer, with the "
                      "baselines'");
    command
        ->add_option("--picture-out", options->judge.pictures.out,
                     "folder for pictures that differ: actual, expected, difference")
        ->type_name("DIR");
    command->add_option("--mark", options->judge.pictures.marks, "repeatable: only the marks of this name")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command
        ->add_option("--seed", options->judge.pictures.seed,
                     "the first of those that pictures and light are drawn with; default: the baseline's. "
                     "Another is as another machine: with noise of its own")
        ->check(CLI::Range(0, 1'000'000'000))
        ->type_name("N");
    command
        ->add_option("--picture-fault", options->picture_fault,
                     "a fault to make in pictures, to see whether it is found: lamp, off, moved, shadow, "
                     "indirect, nan, half, black or tenth")
        ->type_name("FAULT");
    command->add_option("--jobs", options->jobs, "marks to look at at a time, each in a process of its own")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str()
        ->type_name("N");
    command->add_flag("--marks-alone", options->judge.marks_alone, "look at marks and compare nothing else");
    command->add_option("--result", options->result, "folder for a file NAME.json for each recording")
        ->type_name("DIR");
    command->add_option("--as", options->as, "NAME of that file; default: the recording's")->type_name("ID");
    command->add_option("--progress", options->progress, "file that tells the step reached, twice a second")
        ->type_name("FILE");
    command->add_option("--shuffle", options->shuffle,
                        "seed of another legal order of the schedule; 0: the usual");
    command
        ->add_option("--mutant", options->mutant,
                     "a fault to make, to see whether it is found: KIND:NAME@STEP, as in flip:door@412 or "
                     "skip:physics@30")
        ->type_name("FAULT");
    command->add_flag(
        "--brief", options->brief,
        "end after the step in which the fault of --mutant was made; with --picture-fault: no light, "
        "and nothing written to --picture-out");
    command->add_flag("--json", options->json, "print JSON: an object, a list for several files");
    return [options] { return verify(*options); };
}

}  // namespace lanthorn::tools
