// Playing a recording again, and checking the states that it leads to.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>

#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

// Where a replay first left its recording.
struct Divergence {
    std::uint64_t step = 0;  // counts from 0
    std::string part;        // of the state
    std::uint64_t expected = 0;
    std::uint64_t actual = 0;

    // "step 12: door: expected hash 0123456789abcdef, found ..."
    std::string describe() const;
};

// Hands out a recording's inputs and checks the states they lead to.
class Player {
  public:
    // Throws InputError unless `header` (what the replaying program would record) fits the recording's:
    // level, level hash, step rate, input format, parts and sensors. The build may differ; the seed comes
    // from the recording.
    Player(const std::string& file, Recording recording, const RecordingHeader& header);

    std::uint64_t seed() const { return recording_.header.seed; }   // of random numbers
    const Recording& recording() const { return recording_; }       // all of it
    bool done() const { return next_ == recording_.steps.size(); }  // all steps have been checked
    std::uint64_t step() const { return next_; }                    // the one to simulate now, from 0

    // Input of the step to simulate now. Not when done().
    template <StepInput Input>
    Input input() const {
        assert(!done() && sizeof(Input) == recording_.header.input_size);
        Input input;
        std::memcpy(static_cast<void*>(&input), input_bytes().data(), sizeof input);
        return input;
    }
    // The same as bytes, of RecordingHeader::input_size. Not when done().
    std::span<const std::byte> input_bytes() const { return recording_.steps[next_].input; }
    // Readings that entered with that step; the simulation takes these, not fresh ones.
    std::span<const SensorReading> sensors() const { return recording_.steps[next_].sensors; }

    // The state after that step; goes on to the next. Returns false from the first difference on.
    bool check(std::span<const std::uint64_t> hashes);
    // The first; none: all was the same so far.
    const std::optional<Divergence>& divergence() const { return divergence_; }

    // The step to simulate next; done() where there are no more. A divergence that was found stays.
    void go_to(std::uint64_t step) { next_ = std::min<std::uint64_t>(step, recording_.steps.size()); }

  private:
    Recording recording_;
    std::size_t next_ = 0;
    std::optional<Divergence> divergence_;
};

}  // namespace lanthorn::replay
