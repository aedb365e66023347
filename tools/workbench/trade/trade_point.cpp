#include "lanthorn/workbench/trade_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/core/error.h"
#include "lanthorn/workbench/all_settings.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/workbench/scene/median.h"

namespace lanthorn::workbench {

std::string name_of(TradeMotion motion) {
    return std::string(kTradeMotionNames[static_cast<std::size_t>(motion)]);
}

TradeMotion trade_motion_named(std::string_view name) {
    const auto found = std::ranges::find(kTradeMotionNames, name);
    if (found == kTradeMotionNames.end()) {
        throw InputError(fmt::format("found no motion '{}', expected one of {}", name,
                                     fmt::join(kTradeMotionNames, ", ")));
    }
    return static_cast<TradeMotion>(found - kTradeMotionNames.begin());
}

std::string TradePoint::scene_name() const {
    const std::string own = listed_scene(scene, {}).name;
    return motion == TradeMotion::light ? own : own + '-' + name_of(motion);
}

std::string TradePoint::panel() const {
    return motion == TradeMotion::light ? scene : scene + ' ' + name_of(motion);
}

std::string TradePoint::label() const {
    if (!name.empty()) {
        return name;
    }
    const gi::TechniqueEntry* entry = gi::find_technique(technique);
    const bool has_presets = entry != nullptr && entry->has_presets;
    const std::string start = technique == "emc" ? preset
                              : has_presets      ? technique + ' ' + preset
                                                 : technique;
    return assignments.empty() ? start : fmt::format("{}, {}", start, fmt::join(assignments, ", "));
}

std::string TradePoint::knob() const {
    std::string names = name;
    if (!names.empty()) {
        return names;
    }
    for (const std::string& assignment : assignments) {
        const std::string key = assignment.substr(0, assignment.find('='));
        if (key != "gi.emc.final" || assignments.size() == 1) {  // else the stage that reads the others
            names += (names.empty() ? "" : " x ") + key;
        }
    }
    return names.empty() ? "preset" : names;
}

Settings TradePoint::settings(const SettingsSchema& schema) const {
    Settings settings = counted_settings(schema);
    settings.apply_preset(preset);
    for (const auto* list : {&common, &assignments}) {
        for (const std::string& assignment : *list) {
            settings.set_from_text(assignment);
        }
    }
    settings.set_from_text("gi.technique", technique);
    return settings;
}

Spread spread_of(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t n = values.size();
    const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(n)));
    return {median(values), values[rank - 1], values.front()};
}

std::vector<bool> pareto_front(const std::vector<TradeResult>& results, double TradeFigures::*error,
                               double TradeFigures::*cost) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (results[i].measured()) {
            order.push_back(i);
        }
    }
    std::ranges::sort(order, {}, [&](std::size_t i) {
        const TradeResult& r = results[i];
        return std::tuple(r.point.panel(), r.figures.*cost, r.figures.*error);
    });
    std::vector<bool> front(results.size(), false);
    const TradeResult* best = nullptr;
    for (const std::size_t i : order) {
        const TradeResult& r = results[i];
        const bool other_scene = best == nullptr || best->point.panel() != r.point.panel();
        const bool equal = !other_scene && r.figures.*error == best->figures.*error &&
                           r.figures.*cost == best->figures.*cost;
        if (other_scene || equal || r.figures.*error < best->figures.*error) {
            front[i] = true;
            best = &r;
        }
    }
    return front;
}

}  // namespace lanthorn::workbench
