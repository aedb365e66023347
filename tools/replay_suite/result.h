// What became of an item of the plan, as a file: results/KEY.json.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/replay_suite/crash_text.h"
#include "tools/replay_suite/plan.h"

namespace lanthorn::suite {

enum class Verdict { ok, failed, crashed, timed_out, stuck, flaky, bad_input, not_judged };
inline constexpr std::size_t kVerdicts = 8;

const char* verdict_name(Verdict verdict);   // "timed_out", as in files
const char* verdict_words(Verdict verdict);  // "TIMED OUT", as people read it

struct Result {
    std::string id, key;
    ItemKind kind = ItemKind::replay;
    Verdict verdict = Verdict::not_judged;
    std::string line;     // what is wrong, in one line; of a mutant that was caught, where; else empty
    std::string repeats;  // what the second run of a failure did; empty where there was none
    std::string failure;  // names this failure to `replay accept`: "pool.rec-1a2b3c"; empty where all is well
    std::optional<Crash> crash;
    nlohmann::json verify;  // what `replay verify` wrote, without times; null where it wrote nothing
    nlohmann::json times;   // of this run alone: two runs of an item are equal but for this

    bool good() const { return verdict == Verdict::ok; }
    // Of a mutant: whether there was anything to alter.
    bool made() const;
    // Of numbers in `verify`; 0 where there are none.
    std::uint64_t count(const char* name) const;
    // Steps in which each part of the state changed; the same of systems, steps in which they ran.
    std::vector<std::pair<std::string, std::uint64_t>> by_name(const char* name) const;
};

// Names a failure by what it is: verdict, checks, first divergence, place of a crash; not by times.
std::string failure_id(const Result& result);

// `from` without what may differ between two runs of the same: times and speeds.
nlohmann::json without_times(nlohmann::json from);

std::string to_text(const Result& result);  // the file
// Throws InputError for what is none.
Result result_of(const std::string& text, const std::string& file);

// The results of a suite, in a folder. Truth is what lies here, whoever wrote it.
class ResultFiles {
  public:
    // Makes the folder. Throws InputError where it cannot be made.
    explicit ResultFiles(std::filesystem::path folder);

    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path file_of(const std::string& key) const { return folder_ / (key + ".json"); }
    // None where there is no such file, or one that cannot be read: then it is to be made again. A second
    // result of a key that was not equal to the first makes it flaky.
    std::optional<Result> find(const std::string& key) const;
    // Whole or not at all. If there is one already, it stays: an equal one is dropped, one that is not equal
    // is kept beside it for find(). Throws InputError where it cannot be written.
    void put(const Result& result) const;
    // Of results that are no longer wanted.
    void remove(const std::string& key) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace lanthorn::suite
