#include "lanthorn/replay/sensor_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lanthorn::replay {

std::string SensorDivergence::describe() const {
    return fmt::format("step {}: sensor {}: read {:.4g}, recorded {:.4g} to {:.4g}", step, sensor, actual,
                       lower, upper);
}

SensorCheck::SensorCheck(const Recording& recording)
    : names_(recording.header.sensors), recorded_(recording.header.sensors.size()) {
    for (std::uint64_t step = 0; step < recording.steps.size(); ++step) {
        for (const SensorReading& reading : recording.steps[step].sensors) {
            recorded_[reading.sensor].push_back(
                {step - std::min<std::uint64_t>(reading.age, step), static_cast<double>(reading.value)});
        }
    }
    for (std::vector<Reading>& readings : recorded_) {
        std::ranges::stable_sort(readings, {}, &Reading::step);
    }
}

void SensorCheck::check(std::uint32_t sensor, std::uint64_t step, double value) {
    if (divergence_ || sensor >= recorded_.size()) {
        return;
    }
    const std::vector<Reading>& readings = recorded_[sensor];
    const auto after = std::ranges::lower_bound(readings, step, {}, &Reading::step);
    if (after == readings.end() || (after == readings.begin() && after->step != step)) {
        return;
    }
    const auto before = after->step == step ? after : after - 1;
    const double lower = std::min(before->value, after->value), upper = std::max(before->value, after->value);
    ++checked_;
    // Readings through a filter of negative weights may be below 0.
    if (value < lower - kShare * std::abs(lower) - kSlack ||
        value > upper + kShare * std::abs(upper) + kSlack || !std::isfinite(value)) {
        divergence_ = SensorDivergence{step, names_[sensor], lower, upper, value};
    }
}

}  // namespace lanthorn::replay
