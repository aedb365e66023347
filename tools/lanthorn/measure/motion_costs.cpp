// What rules of the plan save, of frames that were measured with and without them.
#include <algorithm>

#include "tools/lanthorn/measure/costs.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::tools {

namespace {

template <class Value>
double over_rounds(const std::vector<FrameCosts>& rounds, const Value& value) {
    std::vector<double> values;
    values.reserve(rounds.size());
    for (const FrameCosts& round : rounds) {
        values.push_back(value(round));
    }
    return median(std::move(values));
}

const PlanLine* line_of(const FrameCosts& costs, const std::string& pass) {
    const auto found = std::ranges::find(costs.plan, pass, &PlanLine::pass);
    return found != costs.plan.end() ? &*found : nullptr;
}

RuleCost rule_cost(const RuleSwitch& rule, const std::vector<FrameCosts>& planned,
                   const std::vector<FrameCosts>& off) {
    const auto longer = [&](double FrameCosts::*member) {
        const auto value = [member](const FrameCosts& round) { return round.*member; };
        return over_rounds(off, value) - over_rounds(planned, value);
    };
    RuleCost cost{rule, longer(&FrameCosts::whole), longer(&FrameCosts::whole_clock), {}, {}};
    for (const PlanLine& line : planned.front().plan) {
        const PlanLine* without = line_of(off.front(), line.pass);
        if (without != nullptr && without->ran > line.ran) {
            cost.lines.push_back(line.pass);
        } else if (without != nullptr && without->ran > 0 && line.ran > 0 && without->size != line.size) {
            cost.smaller.push_back(line.pass);
        }
    }
    return cost;
}

}  // namespace

MotionCosts motion_costs(const std::vector<FrameCosts>& planned,
                         const std::vector<std::vector<FrameCosts>>& off,
                         const std::vector<RuleSwitch>& rules) {
    MotionCosts costs{planned.front(), static_cast<int>(planned.size()), 0, {}, {}};
    FrameCosts& all = costs.planned;
    if (!all.lacking.empty()) {
        return costs;
    }
    for (double FrameCosts::*member :
         {&FrameCosts::whole, &FrameCosts::whole_mean, &FrameCosts::whole_clock, &FrameCosts::outside}) {
        all.*member = over_rounds(planned, [member](const FrameCosts& round) { return round.*member; });
    }
    for (auto& [name, pass] : all.passes) {
        for (double PassCost::*member : {&PassCost::ms, &PassCost::mean, &PassCost::clock}) {
            pass.*member = over_rounds(planned, [&, key = name](const FrameCosts& round) {
                const auto found = round.passes.find(key);
                return found != round.passes.end() ? found->second.*member : 0.0;
            });
        }
    }
    const auto [least, most] = std::ranges::minmax(planned, {}, &FrameCosts::whole);
    costs.noise = most.whole - least.whole;
    for (std::size_t r = 0; r < rules.size(); ++r) {
        costs.rules.push_back(rule_cost(rules[r], planned, off[r]));
    }
    for (const PlanLine& line : all.plan) {
        if (line.ran >= all.frames) {
            continue;
        }
        LeftOutLine& left = costs.left_out.emplace_back(LeftOutLine{line.pass, line.why, line.ran, {}, {}});
        for (const RuleCost& rule : costs.rules) {
            if (std::ranges::find(rule.lines, line.pass) != rule.lines.end()) {
                left.rules.push_back(rule.rule.setting);
                left.ms = std::min(left.ms.value_or(rule.ms), rule.ms);
            }
        }
    }
    return costs;
}

}  // namespace lanthorn::tools
