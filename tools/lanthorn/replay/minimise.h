// Makes a recording that shows a fault shorter, as long as it shows the same fault (reduce_steps.h).
#pragma once

#include <cstdint>
#include <functional>

#include "tools/lanthorn/replay/cause.h"

namespace lanthorn::tools {

struct Minimised {
    replay::Recording recording;  // with the reference's states: a replay here differs in the last step
    Cause cause;                  // of it: same system, field and sign as the first
    int trials = 0;
};

struct MinimiseChoice {
    double seconds = 60;  // after which what has been reached is good enough
    ReplayChoice here = {};
    std::function<void(int trials, std::size_t steps)> progress = {};
};

// Throws InputError where the replay does not differ from the reference.
Minimised minimise(const LevelFile& level, const replay::Recording& recording, Reference& reference,
                   const MinimiseChoice& choice = {});

}  // namespace lanthorn::tools
