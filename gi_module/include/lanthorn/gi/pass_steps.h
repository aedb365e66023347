// What the plans of techniques are made of: passes in the order they run in, each on or off and why. Passes
// and reasons are enums of the technique's own; they become words only where they are printed.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "lanthorn/gi/plan.h"

namespace lanthorn::gi {

// A plan begins with all passes off, for the first of the reasons.
template <class PassKind, class ReasonKind, std::size_t kPasses>
struct PassSteps {
    // What is decided of one pass.
    struct Step {
        bool on = false;
        ReasonKind why{};
    };
    std::array<Step, kPasses> steps;  // by pass

    // Whether the pass runs.
    bool on(PassKind pass) const { return steps[static_cast<std::size_t>(pass)].on; }
    // The reason for which it runs or not.
    ReasonKind why(PassKind pass) const { return steps[static_cast<std::size_t>(pass)].why; }
    // Decides on a pass; a later decision replaces an earlier one.
    void set(PassKind pass, bool on, ReasonKind why) { steps[static_cast<std::size_t>(pass)] = {on, why}; }
};

// The plan in words. `size(pass)`: of one that runs; `why(reason)`: one line.
template <class PassKind, class ReasonKind, std::size_t kPasses, class Size, class Why>
GiPlan steps_in_words(const PassSteps<PassKind, ReasonKind, kPasses>& plan, int bounces,
                      const std::array<std::string_view, kPasses>& names, const Size& size, const Why& why) {
    GiPlan result;
    result.bounces = bounces;
    for (std::size_t i = 0; i < kPasses; ++i) {
        const auto& step = plan.steps[i];
        result.entries.push_back({std::string(names[i]), step.on,
                                  step.on ? std::string(size(static_cast<PassKind>(i))) : std::string(),
                                  std::string(why(step.why))});
    }
    return result;
}

}  // namespace lanthorn::gi
