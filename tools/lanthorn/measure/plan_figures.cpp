#include "tools/lanthorn/measure/plan_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "engine/core/json.h"
#include "gi_module/shared/plan_rules.h"
#include "lanthorn/core/error.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::tools {

namespace {

using nlohmann::ordered_json;

double mean(const std::vector<PlanCost>& motions, double PlanCost::*member) {
    double sum = 0;
    for (const PlanCost& cost : motions) {
        sum += cost.*member;
    }
    return sum / static_cast<double>(motions.size());
}

// Of the motions whose error is above the references' noise; in words, as there may be none.
std::string mean_error(const std::vector<PlanCost>& motions) {
    double sum = 0;
    int count = 0;
    for (const PlanCost& cost : motions) {
        sum += std::isfinite(cost.error) ? cost.error : 0;
        count += std::isfinite(cost.error) ? 1 : 0;
    }
    return count == 0 ? "lost in noise" : fmt::format("{:.3f}", sum / count);
}

// JSON has no NaN: an error below the references' noise is written as null.
double number_or_nan(const ordered_json& value) {
    return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

double frame(const PlanCost& cost) {
    return cost.gi + cost.direct;
}

}  // namespace

std::vector<RuleSwitch> rule_switches() {
    std::vector<RuleSwitch> list;
    list.reserve(gi::kPlanRules.size() + 2);
    for (const gi::PlanRule& rule : gi::kPlanRules) {
        list.push_back({rule.name, rule.leaves_out});
    }
    list.push_back(
        {"render.shadow.kept", "shadow maps in which neither the lamp nor anything else has moved"});
    list.push_back({"render.still.kept",
                    "the G-buffer while neither the view nor surfaces change, and direct light while lamps "
                    "do not either"});
    return list;
}

RuleSwitch rule_named(const std::string& setting) {
    const std::vector<RuleSwitch> rules = rule_switches();
    const auto found = std::ranges::find(rules, setting, &RuleSwitch::setting);
    if (found == rules.end()) {
        std::vector<std::string> names;
        std::ranges::transform(rules, std::back_inserter(names), &RuleSwitch::setting);
        throw InputError(
            fmt::format("found no rule '{}', expected one of {}", setting, fmt::join(names, ", ")));
    }
    return *found;
}

RuleFigures rule_figures(const std::vector<PlanScene>& scenes, std::size_t off) {
    RuleFigures f;
    std::vector<double> saved;
    for (const PlanScene& scene : scenes) {
        const std::vector<PlanCost>&on = scene.cases.front(), &without = scene.cases[off];
        saved.push_back(mean(without, &PlanCost::gi) + mean(without, &PlanCost::direct) -
                        mean(on, &PlanCost::gi) - mean(on, &PlanCost::direct));
        if (f.best_scene.empty() || saved.back() > f.saved_best) {
            f.saved_best = saved.back();
            f.best_scene = scene.name;
            std::size_t best = 0;
            for (std::size_t m = 0; m < on.size(); ++m) {
                best = frame(without[m]) - frame(on[m]) > frame(without[best]) - frame(on[best]) ? m : best;
            }
            f.best_motion = scene.motions[best];
        }
        for (std::size_t m = 0; m < on.size(); ++m) {
            const double added = on[m].error - without[m].error;
            if (std::isfinite(added) && (f.worst_scene.empty() || added > f.error_most)) {
                f.error_most = added;
                f.worst_scene = scene.name;
            }
            f.mb_most = std::max(f.mb_most, without[m].gpu_mb - on[m].gpu_mb);
        }
    }
    f.saved_median = median(saved);
    return f;
}

PlanRatio everything_over_planned(const PlanScene& scene) {
    constexpr double kLeast = 1e-3;
    const std::vector<PlanCost>&on = scene.cases.front(), &all = scene.cases.back();
    const double gi_on = mean(on, &PlanCost::gi), gi_all = mean(all, &PlanCost::gi);
    const double frame_on = gi_on + mean(on, &PlanCost::direct),
                 frame_all = gi_all + mean(all, &PlanCost::direct);
    return {std::max(gi_all, kLeast) / std::max(gi_on, kLeast),
            std::max(frame_all, kLeast) / std::max(frame_on, kLeast)};
}

std::string plan_markdown(const std::vector<PlanScene>& scenes) {
    const std::vector<std::string>& rules = scenes.front().rules;
    std::string text =
        "| rule | leaves out | saves, median scene | best scene | adds to relRMSE at most | GPU memory |\n"
        "|---|---|---|---|---|---|\n";
    for (std::size_t r = 0; r < rules.size(); ++r) {
        const RuleFigures f = rule_figures(scenes, r + 1);
        text += fmt::format("| `{}` | {} | {:.2f} ms | {:.2f} ms ({}, {}) | {:+.3f} ({}) | {:.1f} MB |\n",
                            rules[r], rule_named(rules[r]).leaves_out, f.saved_median, f.saved_best,
                            f.best_scene, f.best_motion, f.error_most, f.worst_scene, f.mb_most);
    }
    if (!scenes.front().has_everything()) {
        return text;
    }
    text +=
        "\n| scene | indirect light, planned | everything on | ratio | whole frame, ratio | relRMSE, planned "
        "| "
        "everything on |\n|---|---|---|---|---|---|---|\n";
    std::vector<double> gi, whole;
    for (const PlanScene& scene : scenes) {
        const PlanRatio ratio = everything_over_planned(scene);
        gi.push_back(ratio.gi);
        whole.push_back(ratio.frame);
        text += fmt::format("| {} | {:.1f} ms | {:.1f} ms | {:.1f} | {:.1f} | {} | {} |\n", scene.name,
                            mean(scene.cases.front(), &PlanCost::gi), mean(scene.cases.back(), &PlanCost::gi),
                            ratio.gi, ratio.frame, mean_error(scene.cases.front()),
                            mean_error(scene.cases.back()));
    }
    return text +
           fmt::format("| **median** | | | **{:.1f}** | **{:.1f}** | | |\n", median(gi), median(whole));
}

ordered_json plan_json(const PlanScene& scene) {
    ordered_json cases = ordered_json::array();
    for (const std::vector<PlanCost>& motions : scene.cases) {
        ordered_json list = ordered_json::array();
        for (const PlanCost& cost : motions) {
            list.push_back({{"gi_ms", cost.gi},
                            {"direct_ms", cost.direct},
                            {"relrmse", cost.error},
                            {"gpu_mb", cost.gpu_mb}});
        }
        cases.push_back(std::move(list));
    }
    return {{"scene", scene.name},
            {"motions", scene.motions},
            {"rules", scene.rules},
            {"cases", std::move(cases)}};
}

ordered_json plan_json(const std::vector<PlanScene>& scenes) {
    ordered_json list = ordered_json::array();
    for (const PlanScene& scene : scenes) {
        list.push_back(plan_json(scene));
    }
    return {{"measure", "plan"}, {"scenes", std::move(list)}};
}

std::vector<PlanScene> read_plan(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        throw InputError(file.string(), "", "cannot be opened");
    }
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const ordered_json root = parse_ordered_json(text, file.string());
    std::vector<PlanScene> scenes;
    if (root.is_object() && root.contains("scenes")) {
        for (const ordered_json& scene : root.at("scenes")) {
            scenes.push_back(plan_from_json(scene, file.string()));
        }
    }
    if (scenes.empty()) {
        throw InputError(file.string(), "", "has no scenes, expected what measure plan --json prints");
    }
    for (const PlanScene& scene : scenes) {
        if (scene.rules != scenes.front().rules ||
            scene.has_everything() != scenes.front().has_everything()) {
            throw InputError(file.string(), scene.name, "is of other rules than the scene before");
        }
    }
    return scenes;
}

PlanScene plan_from_json(const ordered_json& json, const std::string& source) {
    PlanScene scene;
    try {
        scene.name = json.at("scene");
        scene.motions = json.at("motions").get<std::vector<std::string>>();
        scene.rules = json.at("rules").get<std::vector<std::string>>();
        std::ranges::for_each(scene.rules, rule_named);
        for (const ordered_json& motions : json.at("cases")) {
            std::vector<PlanCost>& list = scene.cases.emplace_back();
            for (const ordered_json& cost : motions) {
                list.push_back({cost.at("gi_ms"), cost.at("direct_ms"), number_or_nan(cost.at("relrmse")),
                                cost.at("gpu_mb")});
            }
            if (list.size() != scene.motions.size()) {
                throw InputError(source, "", "has cases of other motions");
            }
        }
    } catch (const ordered_json::exception& error) {
        throw InputError(source, "", fmt::format("is no measured scene: {}", error.what()));
    }
    if (scene.motions.empty() || (!scene.has_everything() && scene.cases.size() != scene.rules.size() + 1)) {
        throw InputError(source, "", "has not as many cases as its rules make");
    }
    return scene;
}

}  // namespace lanthorn::tools
