// Plays a recording and judges it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tools/lanthorn/replay/replayed_level.h"
#include "tools/lanthorn/replay/verdict.h"

namespace lanthorn::tools {

// What is to be judged, and how.
struct JudgeChoice {
    std::string level = {};  // file; empty: level_of()
    int threads = 1;
    std::function<void(App&)> extend = {};                 // ReplayChoice's
    std::function<void(std::uint64_t step)> at_step = {};  // after every step
};

// Throws InputError where the recording, its level or its expectations cannot be read or played.
Verdict judge(const std::string& file, const JudgeChoice& choice = {});

}  // namespace lanthorn::tools
