// A run of frames that keep a budget while things begin to move, stand still again, and another program takes
// a core: what each frame took and what was decided.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/workbench/measure_motions.h"
#include "lanthorn/workbench/render_job.h"

namespace lanthorn::workbench {

struct BudgetRunJob {
    ivec2 size{512, 512};
    int frames = 300;
    Motion motion = Motion::walk;
    BudgetWish wish;
};

// The run's parts, as shares of its frames: nothing moves, then the motion, in the middle of which another
// program takes a core, then nothing moves again.
inline constexpr double kMotionFrom = 0.2, kMotionUntil = 0.75, kCoreFrom = 0.45, kCoreUntil = 0.6;

struct BudgetFrame {
    double ms = 0;                // by the clock of the wish
    std::optional<double> error;  // the last one that was estimated
    double scale = 1;
    std::size_t rung = 0;
    bool moves = false, core = false;
};
struct BudgetRecord {
    std::vector<BudgetFrame> frames;
    BudgetOutcome outcome;

    // What `share` of the frames from `from` on stay below, and what they take in the mean; milliseconds.
    double percentile(double share, std::size_t from) const;
    double mean(std::size_t from) const;
};

// Throws as measure_motions(), and InputError where the scene has no such motion. `done`: after each frame.
BudgetRecord measure_budget(const MotionScene& scene, const Settings& settings, const BudgetRunJob& job,
                            const std::function<void()>& done);

}  // namespace lanthorn::workbench
