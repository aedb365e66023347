// Whether a replay's own sensor readings are those of its recording.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/replay/recording.h"

namespace lanthorn::replay {

// Where a fresh reading first was too far from what was recorded.
struct SensorDivergence {
    std::uint64_t step = 0;  // whose state was looked at
    std::string sensor;
    double lower = 0, upper = 0;  // what was recorded about then, before the tolerance
    double actual = 0;

    // "step 12: sensor far: read 5.1, recorded 0.9 to 1.2"
    std::string describe() const;
};

// The simulation takes the recorded readings; fresh ones are only compared. They are made at other moments,
// by other frames, so that a fresh one is held against the two recorded ones around the step that it looked
// at: it may be kShare beyond the range between them, and kSlack.
class SensorCheck {
  public:
    explicit SensorCheck(const Recording& recording);

    static constexpr double kShare = 0.25;
    static constexpr double kSlack = 0.25;  // lux

    // A reading of a state between two recorded ones; any other, and any after the first divergence, is
    // passed over.
    void check(std::uint32_t sensor, std::uint64_t step, double value);
    // The first; none: all readings fit so far.
    const std::optional<SensorDivergence>& divergence() const { return divergence_; }
    std::uint64_t checked() const { return checked_; }  // how many readings were compared

  private:
    struct Reading {
        std::uint64_t step;
        double value;
    };
    std::vector<std::string> names_;
    std::vector<std::vector<Reading>> recorded_;  // by sensor, in the order of their steps
    std::optional<SensorDivergence> divergence_;
    std::uint64_t checked_ = 0;
};

}  // namespace lanthorn::replay
