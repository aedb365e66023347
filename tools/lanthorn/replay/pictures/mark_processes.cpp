#include "tools/lanthorn/replay/pictures/mark_processes.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "tools/lanthorn/common/child_process.h"
#include "tools/replay_suite/crash_text.h"
#include "tools/replay_suite/files.h"
#include "tools/replay_suite/limited_child.h"

namespace lanthorn::tools {

namespace {

// Pictures of large sizes take their time; who watches this process has limits of his own.
constexpr suite::Limits kLimits{24 * 3600.0, 24 * 3600.0, 0};

std::vector<std::string> options_of(const PictureChoice& choice) {
    std::vector<std::string> options;
    const auto add = [&](const char* name, const std::string& value) {
        options.insert(options.end(), {name, value});
    };
    if (choice.pictures) {
        options.emplace_back("--pictures");
    }
    if (choice.light) {
        options.emplace_back("--light");
    }
    if (!choice.out.empty()) {
        add("--picture-out", choice.out);
    }
    if (choice.fault) {
        add("--picture-fault", std::string(kPictureFaults[static_cast<std::size_t>(*choice.fault)]));
    }
    if (choice.seed) {
        add("--seed", std::to_string(*choice.seed));
    }
    return options;
}

PictureVerdict looked_at(const std::string& file, const replay::Mark& mark,
                         const std::vector<std::string>& options, int rasteriser_threads) {
    const suite::Scratch scratch = suite::Scratch::temporary("lanthorn-mark");
    std::vector<std::string> command = {
        own_executable(),          "replay", "verify", file, "--mark", mark.name, "--marks-alone", "--result",
        scratch.folder().string(), "--as",   "mark"};
    command.insert(command.end(), options.begin(), options.end());
    const suite::ChildRun child = suite::run_limited(
        command, {fmt::format("LP_NUM_THREADS={}", rasteriser_threads)}, kLimits, "", [] { return false; });
    const std::string text = suite::read_if_there(scratch.at("mark.json"));
    if (child.end == suite::ChildRun::End::exited && (child.code == 0 || child.code == 1) && !text.empty()) {
        return picture_of(parse_json_object(text, "mark.json", "a result").at("pictures").at(0));
    }
    if (child.end == suite::ChildRun::End::exited && child.code > 1) {
        std::string line = child.err.substr(0, child.err.find_last_not_of('\n') + 1);
        line = line.substr(line.find_last_of('\n') + 1);
        line = line.starts_with("lanthorn: ") ? line.substr(std::string("lanthorn: ").size()) : line;
        if (child.code == static_cast<int>(ExitCode::bad_input)) {
            throw InputError(line);
        }
        throw Error(static_cast<ExitCode>(child.code), line);
    }
    PictureVerdict lost{.mark = mark.name, .step = mark.step};
    lost.failed = lost.light_failed = true;
    lost.text = lost.light = child.end == suite::ChildRun::End::signalled
                                 ? fmt::format("its process ended by {}", suite::signal_words(child.signal))
                                 : "its process ended without a result";
    return lost;
}

}  // namespace

MarkProcesses::MarkProcesses(int jobs, const std::vector<std::string>& files, const PictureChoice& choice,
                             const std::vector<std::string>& options)
    : choice_(choice) {
    std::vector<std::string> all = options_of(choice);
    all.insert(all.end(), options.begin(), options.end());
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / jobs);
    for (const std::string& file : std::set<std::string>(files.begin(), files.end())) {
        std::vector<replay::Mark> marks;
        try {
            marks = chosen_marks(file, replay::read_recording(file), choice.marks);
        } catch (const InputError& error) {
            refused_[file] = error.what();
        }
        for (const replay::Mark& mark : marks) {
            Job& job = jobs_.emplace_back([=] { return looked_at(file, mark, all, threads); });
            found_[file].push_back(job.get_future());
        }
    }
    const auto work = [this](const std::stop_token& stop) {
        for (std::size_t at; !stop.stop_requested() && (at = next_.fetch_add(1)) < jobs_.size();) {
            jobs_[at]();
        }
    };
    for (int i = 0; i < jobs; ++i) {
        threads_.emplace_back(work);
    }
}

MarkProcesses::~MarkProcesses() = default;

PictureResults MarkProcesses::of(const std::string& file) {
    if (const auto refused = refused_.find(file); refused != refused_.end()) {
        throw InputError(refused->second);
    }
    std::vector<PictureVerdict> pictures;
    for (const std::shared_future<PictureVerdict>& one : found_[file]) {
        pictures.push_back(one.get());
    }
    return results_of(std::move(pictures), choice_);
}

}  // namespace lanthorn::tools
