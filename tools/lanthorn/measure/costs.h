// What a scene costs and why: milliseconds by pass and by light, megabytes by asset, and what the plan left
// out.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/workbench/measure_motions.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/lanthorn/measure/plan_figures.h"
#include "tools/workbench/measure/frame_costs.h"

namespace lanthorn::tools {

// What a rule of the plan leaves out of the frames of one motion.
struct RuleCost {
    RuleSwitch rule;
    // That a frame would be longer by without it, medians over rounds: as FrameCosts counts, and by the
    // clock.
    double ms = 0, clock = 0;
    std::vector<std::string> lines;    // of the plan, which it keeps from being done in some frame or in all
    std::vector<std::string> smaller;  // which are done, with another size
};

// A line of the plan that some frame leaves out.
struct LeftOutLine {
    std::string pass, why;
    int ran = 0;  // of the motion's frames
    std::vector<std::string>
        rules;  // those that it would be done in more frames without; none: no rule's work
    // Milliseconds that a frame would be longer by without the rule among them that saves least: the line
    // with what it brings along.
    std::optional<double> ms;
};

// The frames of one motion.
struct MotionCosts {
    FrameCosts planned;  // of the first round; its whole and passes are medians over rounds
    int rounds = 1;
    double noise = 0;  // milliseconds by which the rounds' whole frames differ
    std::vector<RuleCost> rules;
    std::vector<LeftOutLine> left_out;
};

// A light, and the milliseconds that frames are longer for its being there.
struct LightCost {
    std::string name, kind;  // "lamp", "glowing surface", "sky"
    double share = 0;        // 0..1 of all light that falls on what the camera sees
    double lux = 0;          // the mean of what is seen
    struct Ms {
        double ms = 0, noise = 0;  // as FrameCosts counts
        double clock = 0;          // by the clock
    };
    std::vector<std::optional<Ms>> by_motion;  // of SceneCosts::light_motions; none: it was not muted
};

struct SceneCosts {
    std::string name;
    std::vector<MotionCosts> motions;  // rest first
    std::vector<Motion> light_motions;
    std::vector<LightCost> lights;  // by what they give, most first
};

struct CostsJob {
    FrameCostsJob frames;
    std::vector<Motion> motions = {Motion::rest};
    int rounds = 2;  // in which all cases are measured, one after the other
    int lights = 8;  // that are muted at most: those that give most
};

// The rules' costs and the lines that are left out, of one motion: `planned` and each of `off` (one a rule,
// in the order of `rules`) by round.
MotionCosts motion_costs(const std::vector<FrameCosts>& planned,
                         const std::vector<std::vector<FrameCosts>>& off,
                         const std::vector<RuleSwitch>& rules);

// Throws what measure_frame_costs() does. `done`: after each step; what it throws ends the measurement.
SceneCosts measure_costs(const MotionScene& scene, const Settings& settings, const CostsJob& job,
                         const std::function<void()>& done);

}  // namespace lanthorn::tools
