// Makes the steps of a session fewer, its presses and its movements, as long as they show the same (delta
// debugging, Zeller and Hildebrandt 2002).
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "lanthorn/replay/recording.h"

namespace lanthorn::tools {

// Whether steps still show it: those to go on with, which may end earlier; nothing where they do not.
using StepsOracle =
    std::function<std::optional<std::vector<replay::RecordedStep>>(std::vector<replay::RecordedStep>)>;

struct ReducedSteps {
    std::vector<replay::RecordedStep> steps;
    int trials = 0;
};

// Of steps that show it. Ends after `seconds` with what it has. Knows the inputs of `lamplighter`.
// `progress`: called before each trial, with their number and the steps that are left.
ReducedSteps reduce_steps(std::vector<replay::RecordedStep> steps, const StepsOracle& oracle, double seconds,
                          const std::function<void(int trials, std::size_t steps)>& progress = {});

// Buttons that go down, each counted once.
std::size_t presses(const std::vector<replay::RecordedStep>& steps);

}  // namespace lanthorn::tools
