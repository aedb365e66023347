// What each rule of the plan saves, and the error that it adds, over several scenes.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

// One setting that switches a rule off, and what the rule leaves out.
struct RuleSwitch {
    std::string setting;  // a boolean; false: the plan works as if the scene required it
    std::string leaves_out;
};
// Those of indirect light, then those of shadow maps and of a view that stands.
std::vector<RuleSwitch> rule_switches();
// The one of that setting. Throws InputError, which lists them, for another.
RuleSwitch rule_named(const std::string& setting);

// A frame of a scene in a motion, by one case.
struct PlanCost {
    double gi = 0, direct = 0;  // milliseconds a frame, indirect light and all the rest: processor
                                // time; of a GPU by its clock
    double error = 0;           // relRMSE of the last frame's indirect light
    double gpu_mb = 0;
};

// What was measured of a scene.
struct PlanScene {
    std::string name;
    std::vector<std::string> motions;
    std::vector<std::string> rules;  // that were switched off, by their settings
    // [case][motion]: all rules on; each of `rules` off; all off, where it was measured.
    std::vector<std::vector<PlanCost>> cases;

    bool has_everything() const { return cases.size() == rules.size() + 2; }
};

// A rule over all scenes. Times are means over a scene's motions.
struct RuleFigures {
    double saved_median = 0, saved_best = 0;  // milliseconds a frame
    std::string best_scene;
    std::string best_motion;  // the one in which it saves most there
    double error_most = 0;    // what the rule adds to relRMSE, in the motion in which that is most
    std::string worst_scene;
    double mb_most = 0;  // GPU memory that it saves
};
// Of the case at that place. At least one scene.
RuleFigures rule_figures(const std::vector<PlanScene>& scenes, std::size_t off);

// How many times longer a frame takes without any rule: indirect light, and the whole frame.
struct PlanRatio {
    double gi = 1, frame = 1;
};
// A mean over motions of what is planned that takes no time at all counts as a thousandth of a millisecond.
PlanRatio everything_over_planned(const PlanScene& scene);

// The tables of docs/plan.md: rules, and scenes where everything_over_planned() is known. Of scenes with the
// same rules.
std::string plan_markdown(const std::vector<PlanScene>& scenes);
nlohmann::ordered_json plan_json(const PlanScene& scene);
// The object that the command prints for --json.
nlohmann::ordered_json plan_json(const std::vector<PlanScene>& scenes);
// What plan_json() wrote. Throws InputError, which names `source`, for anything else.
PlanScene plan_from_json(const nlohmann::ordered_json& json, const std::string& source);
// A file of what the command printed for --json. Throws InputError for any other, and for scenes of several
// lists of rules.
std::vector<PlanScene> read_plan(const std::filesystem::path& file);

}  // namespace lanthorn::tools
