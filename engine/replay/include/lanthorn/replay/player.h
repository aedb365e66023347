// Playing a recording again, and comparing the states that it leads to.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

// A stretch of steps whose state was another than recorded.
struct Divergence {
    std::uint64_t step = 0;          // the first, from 0
    std::uint64_t last = 0;          // the last of them so far
    std::vector<std::string> parts;  // that differed after the first; empty where the root alone says so
    std::uint64_t expected = 0, actual = 0;  // roots after the first; both 0 where parts alone were compared

    // "step 12: door, body_motion: not as recorded (root 0123456789abcdef, expected ...)"
    std::string describe() const;
};

// What a replay has compared so far.
struct Comparison {
    std::uint64_t steps = 0;    // compared
    std::uint64_t hashes = 0;   // one a step and part that was compared
    std::uint64_t equal = 0;    // steps before the first that differed
    std::uint64_t live = 0;     // steps that changed something
    std::uint64_t unknown = 0;  // steps played whose state the recording does not know
    bool roots = false;         // every recorded part is compared: roots are; else tags alone (1 byte a part)
    std::vector<std::string> parts;         // that are compared, as recorded
    std::vector<std::uint64_t> changed;     // one a part: steps in which it changed here
    std::vector<std::string> not_compared;  // a line each: "cloth: its fields have changed"
    std::vector<Divergence> divergences;    // by step, at most kMostDivergences

    static constexpr std::size_t kMostDivergences = 1000;
};

// Hands out a recording's inputs and checks the states they lead to.
class Player {
  public:
    // Throws InputError unless `header` (what the replaying program would record) fits the recording's:
    // level, level hash, step rate, input format, sensors, and at least one part of the state that both have.
    // The build may differ; the seed comes from the recording. Parts of one name and schema are compared, the
    // others named in comparison().
    Player(const std::string& file, std::shared_ptr<const Recording> recording,
           const RecordingHeader& header);

    std::uint64_t seed() const { return recording_->header.seed; }   // of random numbers
    const Recording& recording() const { return *recording_; }       // all of it
    bool done() const { return next_ == recording_->steps.size(); }  // all steps have been checked
    std::uint64_t step() const { return next_; }                     // the one to simulate now, from 0

    // Input of the step to simulate now. Not when done().
    template <StepInput Input>
    Input input() const {
        assert(!done() && sizeof(Input) == recording_->header.input_size);
        Input input;
        std::memcpy(static_cast<void*>(&input), input_bytes().data(), sizeof input);
        return input;
    }
    // The same as bytes, of RecordingHeader::input_size. Not when done().
    std::span<const std::byte> input_bytes() const { return recording_->steps[next_].input; }
    // Readings that entered with that step; the simulation takes these, not fresh ones.
    std::span<const SensorReading> sensors() const { return recording_->steps[next_].sensors; }

    // The state after that step, one hash a part of the header given; goes on to the next. Whether it is as
    // recorded.
    bool check(std::span<const std::uint64_t> hashes);
    // The first; none: all was the same so far.
    std::optional<Divergence> divergence() const;
    const Comparison& comparison() const { return comparison_; }  // all of it so far
    bool apart() const { return apart_; }                         // the last step differed

    // The step to simulate next; done() where there are no more. What was compared stays. O(steps between,
    // from the first on where it is an earlier one).
    void go_to(std::uint64_t step);

  private:
    struct Pair {
        std::size_t recorded, own;  // numbers of one part
    };
    void find_common(const std::string& file, const RecordingHeader& header);
    std::vector<std::string> differing(std::span<const std::uint64_t> hashes,
                                       const std::vector<bool>& changed) const;
    void count_changes(std::span<const std::uint64_t> hashes);
    void note(const std::vector<std::string>& parts, std::uint64_t root);

    std::shared_ptr<const Recording> recording_;
    std::vector<Pair> common_;
    std::vector<std::uint8_t> tags_;     // recorded, by recorded part, before the step to simulate now
    std::vector<std::uint64_t> before_;  // own hashes after the last step; empty: not known
    std::size_t next_ = 0;
    bool apart_ = false;  // the last step differed
    Comparison comparison_;
};

}  // namespace lanthorn::replay
