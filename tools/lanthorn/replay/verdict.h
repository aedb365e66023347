// What a verification found: for people as lines, for programs as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/replay/player.h"
#include "lanthorn/replay/recording.h"
#include "tools/lanthorn/replay/mutant.h"

namespace lanthorn::tools {

struct Check {
    enum class Verdict { ok, failed, none };
    std::string name;
    Verdict verdict = Verdict::none;
    std::string text;  // one line
};

// The session in at most kMostBins stretches of equal length.
struct Timeline {
    static constexpr std::uint64_t kMostBins = 400;

    std::uint64_t bin_steps = 30;
    std::vector<std::uint32_t> inputs;  // by bin: steps whose input is another than that of the step before
    std::vector<std::uint32_t> parts;   // by bin: distinct parts that were recorded to change
};

Timeline timeline_of(const replay::Recording& recording);

// What became of a mark's picture and of its light.
struct PictureVerdict {
    std::string mark = {};
    std::uint64_t step = 0;
    bool failed = false;        // the picture
    std::string text = {};      // one line
    std::string fault = {};     // that was made to be found; empty: none
    double flip = 0;            // found; 0: equal to the bit, or nothing to compare
    bool light_failed = false;  // worse than the baseline's
    std::string light = {};     // one line; empty: not measured
    // Files of what differs; empty: not written.
    std::string actual = {}, expected = {}, difference = {};
};

struct Verdict {
    std::string file;
    std::string key;    // hash of what it depends on: recording, level, build
    std::string error;  // bad input: the line; empty: it could be judged
    replay::RecordingHeader header;
    std::vector<replay::Mark> marks;
    std::string build;    // that judged
    std::string cut_off;  // Recording::cut_off
    std::uint64_t steps = 0;
    double speed = 0;        // simulated steps a second of wall time
    double cpu_seconds = 0;  // of the simulation
    replay::Comparison comparison;
    std::vector<Check> checks;
    std::vector<PictureVerdict> pictures;
    std::vector<std::pair<std::string, std::uint64_t>> systems_ran;  // of the fixed step: in how many
    Timeline timeline;
    std::optional<MutantReport> mutant;  // the fault that it was played with

    bool failed() const;
    double seconds() const { return static_cast<double>(steps) / header.step_rate; }
};

// A heading, a line a check, and what it comes to, with newlines.
std::string verdict_text(const Verdict& verdict);
// The same as in docs/replay.md. Of two runs of one build the same but for simulated_steps_per_second and
// cpu_s.
nlohmann::ordered_json verdict_json(const Verdict& verdict);
// An entry of its list `pictures`.
PictureVerdict picture_of(const nlohmann::json& json);

}  // namespace lanthorn::tools
