// Plays a recording and judges it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tools/lanthorn/replay/pictures/picture_check.h"
#include "tools/lanthorn/replay/replayed_level.h"
#include "tools/lanthorn/replay/verdict.h"

namespace lanthorn::tools {

// Of what a recording's states depend on: its bytes, the level's, the build.
std::string key_of(const std::string& file, const LevelFile& level, const std::string& settings = "");

// What is to be judged, and how.
struct JudgeChoice {
    std::string level = {};  // file; empty: level_of()
    int threads = 1;
    bool sensors = false;                   // draw, so that light sensors read again
    std::uint64_t heavy = 0;                // steps from one heavy_check() to the next; 0: none
    PictureChoice pictures = {};            // at the recording's marks, drawn after it was played
    bool marks_alone = false;               // these are looked at, and nothing else is compared
    std::function<void(App&)> extend = {};  // ReplayChoice's
    std::function<void(std::uint64_t step)> at_step = {};  // after every step
    std::function<bool(std::uint64_t step)> enough = {};   // after every step: whether to end with it
};

// Throws InputError where the recording, its level or its expectations cannot be read or played.
Verdict judge(const std::string& file, const JudgeChoice& choice = {});

}  // namespace lanthorn::tools
