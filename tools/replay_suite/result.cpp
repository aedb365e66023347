#include "tools/replay_suite/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "engine/core/json.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "lanthorn/replay/content_hash.h"
#include "tools/replay_suite/files.h"

namespace lanthorn::suite {

namespace {

using nlohmann::json;

struct Names {
    const char* name;
    const char* words;
};
constexpr Names kNames[kVerdicts] = {
    {"ok", "ok"},       {"failed", "FAIL"}, {"crashed", "CRASHED"},     {"timed_out", "TIMED OUT"},
    {"stuck", "STUCK"}, {"flaky", "FLAKY"}, {"bad_input", "BAD INPUT"}, {"not_judged", "NOT JUDGED"}};
constexpr const char* kTimes[] = {"wall_s", "cpu_s", "simulated_steps_per_second"};

json crash_json(const std::optional<Crash>& crash) {
    if (!crash) {
        return nullptr;
    }
    return {{"signal", crash->signal},
            {"name", signal_words(crash->signal)},
            {"step", crash->step},
            {"frames", crash->frames}};
}

std::filesystem::path other_of(const std::filesystem::path& file) {
    std::filesystem::path other = file;
    return other.replace_extension(".other");
}

}  // namespace

const char* verdict_name(Verdict verdict) {
    return kNames[static_cast<std::size_t>(verdict)].name;
}

const char* verdict_words(Verdict verdict) {
    return kNames[static_cast<std::size_t>(verdict)].words;
}

bool Result::made() const {
    return verify.is_object() && verify.contains("mutant") && verify["mutant"].value("made", false);
}

std::uint64_t Result::count(const char* name) const {
    if (!verify.is_object() || !verify.contains(name) || !verify[name].is_number_integer()) {
        return 0;
    }
    return verify[name].get<std::uint64_t>();
}

std::vector<std::pair<std::string, std::uint64_t>> Result::by_name(const char* name) const {
    std::vector<std::pair<std::string, std::uint64_t>> list;
    if (verify.is_object() && verify.contains(name) && verify[name].is_object()) {
        for (const auto& [part, steps] : verify[name].items()) {
            if (steps.is_number_integer()) {
                list.emplace_back(part, steps.get<std::uint64_t>());
            }
        }
    }
    return list;
}

json without_times(json from) {
    if (from.is_object()) {
        for (const char* name : kTimes) {
            from.erase(name);
        }
        if (from.contains("checks") && from["checks"].is_array()) {
            json kept = json::array();
            for (json& check : from["checks"]) {
                if (!check.is_object() || check.value("name", "") != "time") {
                    kept.push_back(std::move(check));
                }
            }
            from["checks"] = std::move(kept);
        }
    }
    return from;
}

std::string failure_id(const Result& result) {
    if (result.good()) {
        return "";
    }
    json what = {verdict_name(result.verdict)};
    if (result.crash) {
        what.push_back(result.crash->signal);
        what.push_back(result.crash->step);
        what.push_back(result.crash->where());
    }
    if (result.verify.is_object()) {
        for (const json& check : result.verify.value("checks", json::array())) {
            if (check.is_object() && check.value("verdict", "") == "failed") {
                what.push_back(check.value("name", ""));
            }
        }
        const json divergences = result.verify.value("divergences", json::array());
        if (!divergences.empty() && divergences.front().is_object()) {
            what.push_back(divergences.front().value("step", json()));
            what.push_back(divergences.front().value("parts", json()));
        }
    } else if (!result.crash) {
        what.push_back(result.line);
    }
    const std::string text = what.dump(-1, ' ', false, json::error_handler_t::replace);
    const std::uint64_t hash = replay::hash_bytes(std::as_bytes(std::span(text)));
    return fmt::format("{}-{:06x}", result.id, hash & 0xffffffu);
}

std::string to_text(const Result& result) {
    const json text = {{"id", result.id},
                       {"key", result.key},
                       {"kind", kItemKinds[static_cast<std::size_t>(result.kind)]},
                       {"verdict", verdict_name(result.verdict)},
                       {"line", result.line},
                       {"repeats", result.repeats},
                       {"failure", result.failure},
                       {"crash", crash_json(result.crash)},
                       {"verify", result.verify},
                       {"times", result.times}};
    return text.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

Result result_of(const std::string& text, const std::string& file) {
    const json from = parse_json_object(text, file, "a result");
    try {
        Result result;
        result.id = from.at("id");
        result.key = from.at("key");
        const auto kind = std::ranges::find(kItemKinds, from.at("kind").get<std::string>());
        const auto verdict = std::ranges::find(kNames, from.at("verdict").get<std::string>(), &Names::name);
        if (kind == std::end(kItemKinds) || verdict == std::end(kNames)) {
            throw InputError(file, "", "found a kind or a verdict that there is not");
        }
        result.kind = static_cast<ItemKind>(kind - std::begin(kItemKinds));
        result.verdict = static_cast<Verdict>(verdict - std::begin(kNames));
        result.line = from.at("line");
        result.repeats = from.at("repeats");
        result.failure = from.at("failure");
        if (const json& crash = from.at("crash"); crash.is_object()) {
            result.crash = Crash{crash.at("signal"), crash.at("step"),
                                 crash.at("frames").get<std::vector<std::string>>()};
        }
        result.verify = from.at("verify");
        result.times = from.at("times");
        return result;
    } catch (const json::exception& error) {
        throw InputError(file, "", std::string("found no result of a suite: ") + error.what());
    }
}

ResultFiles::ResultFiles(std::filesystem::path folder) : folder_(std::move(folder)) {
    make_folder(folder_);
}

std::optional<Result> ResultFiles::find(const std::string& key) const {
    const auto file = file_of(key);
    const auto read = [](const std::filesystem::path& path) -> std::optional<Result> {
        const std::string text = read_if_there(path);
        try {
            return text.empty() ? std::nullopt : std::optional(result_of(text, path.string()));
        } catch (const Error&) {
            return {};  // not ours, or damaged by a disk: what it was of is judged again
        }
    };
    std::optional<Result> result = read(file);
    if (const auto other = read(other_of(file)); result && other) {
        result->repeats =
            fmt::format("two runs of the same differ: {}, {} and {}, {}", verdict_words(result->verdict),
                        result->line, verdict_words(other->verdict), other->line);
        result->line = "not the same in every run";
        result->verdict = Verdict::flaky;
        result->failure = failure_id(*result);
    }
    return result;
}

void ResultFiles::put(const Result& result) const {
    const auto file = file_of(result.key);
    const auto bare = [](Result r) {
        r.times = nullptr;
        return to_text(r);
    };
    if (const std::string text = read_if_there(file); !text.empty()) {
        try {
            if (bare(result_of(text, file.string())) != bare(result)) {
                write_file(other_of(file), to_text(result));
            }
            return;
        } catch (const Error&) {
            // Damaged: replaced.
        }
    }
    write_file(file, to_text(result));
}

void ResultFiles::remove(const std::string& key) const {
    std::error_code ignored;
    std::filesystem::remove(file_of(key), ignored);
    std::filesystem::remove(other_of(file_of(key)), ignored);
}

}  // namespace lanthorn::suite
