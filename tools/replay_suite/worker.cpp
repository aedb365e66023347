#include "tools/replay_suite/worker.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>

#include "engine/core/crash_report.h"
#include "engine/core/json.h"
#include "lanthorn/core/error.h"
#include "tools/replay_suite/files.h"

namespace lanthorn::suite {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string host() {
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    return name;
}

std::string last_line(std::string text) {
    text.erase(text.find_last_not_of(" \r\n") + 1);
    return text.substr(text.find_last_of('\n') + 1);
}

std::string list(const json& names) {
    std::vector<std::string> words;
    for (const json& name : names) {
        words.push_back(name.is_string() ? name.get<std::string>() : name.dump());
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

// "state: step 912: body_motion differs (and 1 more)".
std::string failed_checks(const json& verify) {
    std::string line;
    int more = 0;
    for (const json& check : verify.value("checks", json::array())) {
        if (!check.is_object() || check.value("verdict", "") != "failed") {
            continue;
        }
        if (line.empty()) {
            line = check.value("name", "") + ": " + check.value("text", "");
        } else {
            ++more;
        }
    }
    return more > 0 ? fmt::format("{} (and {} more)", line, more) : line;
}

// Whether a fault that was made is found, at its step and by the part that was altered.
void judge_mutant(const std::vector<std::string>& expected, Result& result) {
    const json report = result.verify.is_object() ? result.verify.value("mutant", json()) : json();
    if (!report.is_object()) {
        return;  // it could not be played
    }
    if (!result.made()) {
        result.line = "not made: nothing of the kind is there";
        result.verdict = Verdict::ok;
        return;
    }
    const std::string made = report.value("words", "");
    const auto step = report.value("step", std::uint64_t{0});
    const json altered = report.value("parts", json::array());
    const json divergences = result.verify.value("divergences", json::array());
    if (divergences.empty()) {
        result.line = fmt::format("survived: {}", made);
        result.verdict = Verdict::failed;
        return;
    }
    const json found = divergences.front().value("parts", json::array());
    const auto has = [&](const json& part) { return std::ranges::find(found, part) != found.end(); };
    // What was altered must be named and nothing else; of a system, something that it would have changed.
    const bool named = altered.empty() ? expected.empty() || std::ranges::any_of(expected, has)
                                       : found.size() == altered.size() && std::ranges::all_of(altered, has);
    const auto at = divergences.front().value("step", std::uint64_t{0});
    result.line = fmt::format("step {}: {}", at, list(found));
    if (!made.empty()) {
        result.line += " (" + made + ")";
    }
    result.verdict = Verdict::ok;
    if (at != step || !named) {
        result.line +=
            fmt::format(", expected step {}: {}", step,
                        altered.empty() ? fmt::format("{}", fmt::join(expected, " or ")) : list(altered));
        result.verdict = Verdict::failed;
    }
}

// Whether the picture in which a fault was made is found to be wrong.
void judge_blemish(Result& result) {
    const json pictures =
        result.verify.is_object() ? result.verify.value("pictures", json::array()) : json::array();
    if (pictures.empty()) {
        return;  // it could not be drawn
    }
    const json& picture = pictures.front();
    const std::string fault = picture.value("fault", "");
    result.verdict = Verdict::ok;
    if (fault.empty()) {
        result.line = "not made: nothing of the kind is there";
    } else if (picture.value("failed", false)) {
        result.line = fmt::format("{}: {}", fault, picture.value("text", ""));
    } else {
        result.line = fmt::format("survived: {}: {}", fault, picture.value("text", ""));
        result.verdict = Verdict::failed;
    }
}

}  // namespace

struct Worker::Attempt {
    Result result;
    bool stopped = false;
    bool machine = false;  // it is not the recording's fault

    std::string text() const {
        Result bare = result;
        bare.times = nullptr;
        return to_text(bare);
    }
};

Worker::Worker(const Plan& plan, fs::path scratch, std::function<bool()> stop)
    : plan_(plan), scratch_(std::move(scratch)), stop_(std::move(stop)) {}

Worker::Attempt Worker::attempt(const Item& item, int run) const {
    const Scratch scratch(scratch_ / fmt::format("{}-{}-{}-{}", item.key, host(), getpid(), run));
    const fs::path progress = scratch.folder() / "progress", crash = scratch.folder() / "crash";
    std::vector<std::string> command = {plan_.program,    "replay", "verify", item.file,    "--result",
                                        scratch.folder(), "--as",   "result", "--progress", progress};
    command.insert(command.end(), plan_.options.begin(), plan_.options.end());
    command.insert(command.end(), item.options.begin(), item.options.end());
    const ChildRun child = run_limited(command,
                                       {fmt::format("{}={}", kCrashFileVariable, crash.string()),
                                        fmt::format("LANTHORN_REPLAY_RUN={}", run)},
                                       plan_.limits, progress, stop_);
    Attempt made;
    Result& result = made.result;
    result.id = item.id;
    result.key = item.key;
    result.kind = item.kind;
    result.times = {{"host", host()}, {"wall_s", child.wall_s}, {"cpu_s", child.cpu_s}};
    if (const std::string text = read_if_there(scratch.folder() / "result.json"); !text.empty()) {
        const json verify = parse_json_object(text, "result.json", "a result");
        result.verify = without_times(verify);
        if (verify.contains("simulated_steps_per_second")) {
            result.times["simulated_steps_per_second"] = verify["simulated_steps_per_second"];
        }
    }
    const auto where = [&](Verdict verdict, const std::string& words) {
        result.verdict = verdict;
        result.line = words;
        if (const auto told = read_crash(crash, plan_.program)) {
            if (verdict == Verdict::crashed) {
                result.crash = told;
                result.line += fmt::format(" after step {}", told->step);
            } else {  // how far it came differs from run to run
                result.times["step"] = told->step;
                result.times["frames"] = told->frames;
            }
            if (verdict == Verdict::crashed && !told->where().empty()) {
                result.line += ", in " + told->where();
            }
        } else if (child.last_step) {
            result.times["step"] = *child.last_step;
        }
    };
    switch (child.end) {
        case ChildRun::End::stopped:
            made.stopped = true;
            break;
        case ChildRun::End::not_started:
            made.machine = true;
            result.verdict = Verdict::not_judged;
            result.line = fmt::format("{} cannot be started: {}", plan_.program, last_line(child.err));
            break;
        case ChildRun::End::signalled:
            where(Verdict::crashed, signal_words(child.signal));
            break;
        case ChildRun::End::timed_out:
            where(Verdict::timed_out, fmt::format("not done after {} s", plan_.limits.seconds));
            break;
        case ChildRun::End::stuck:
            where(Verdict::stuck, fmt::format("no step in {} s", plan_.limits.stuck_seconds));
            break;
        case ChildRun::End::exited:
            result.verdict = child.code == 0   ? Verdict::ok
                             : child.code == 1 ? Verdict::failed
                             : child.code == 2 ? Verdict::bad_input
                                               : Verdict::not_judged;
            made.machine = result.verdict == Verdict::not_judged;
            if (child.code != 0) {
                result.line = result.verify.is_object() ? failed_checks(result.verify) : "";
                if (result.line.empty()) {
                    result.line = last_line(child.err);
                }
            } else if (item.kind != ItemKind::watch && result.count("hashes_compared") == 0) {
                result.verdict = Verdict::failed;
                result.line = "compared no hash: nothing was checked";
            }
    }
    if (item.kind == ItemKind::mutant && child.end == ChildRun::End::exited && !made.machine) {
        judge_mutant(item.expect, result);
    }
    if (item.kind == ItemKind::blemish && child.end == ChildRun::End::exited && !made.machine) {
        judge_blemish(result);
    }
    result.failure = failure_id(result);
    return made;
}

std::optional<Result> Worker::judge(const Item& item) const {
    Attempt first = attempt(item, 1);
    if (first.stopped) {
        return {};
    }
    if (first.result.good() || is_fault(item.kind)) {
        return first.result;
    }
    Attempt second = attempt(item, 2);
    if (second.stopped) {
        return {};
    }
    if (first.machine || second.machine) {
        if (!second.machine && second.result.good()) {
            return second.result;
        }
        Result& lost = first.machine ? first.result : second.result;
        return lost;
    }
    Result& result = first.result;
    if (first.text() == second.text()) {
        result.repeats = "alone: again, the same";
        return result;
    }
    result.repeats = fmt::format("first: {}, {}; alone: {}{}{}", verdict_words(result.verdict), result.line,
                                 verdict_words(second.result.verdict), second.result.line.empty() ? "" : ", ",
                                 second.result.line);
    if (second.result.verdict != result.verdict || (result.verdict != Verdict::timed_out)) {
        result.line = fmt::format("not the same in every run; {}", result.line);
        result.verdict = Verdict::flaky;
        result.failure = failure_id(result);
    }
    return result;
}

}  // namespace lanthorn::suite
