#include "engine/runtime/budget_ladders.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lanthorn/core/settings_schema.h"

namespace lanthorn {

namespace {

constexpr std::array kScales = {1.0, 0.87, 0.75, 0.65, 0.56, 0.48, 0.42, 0.36};
constexpr std::size_t kScalesOfBest = 4;  // down to here a smaller picture is better than a lower preset

// Of a frame's time, relative to that of `low`, and the share of it that no smaller picture spares: maps,
// photons and shadows, as a lantern is carried about at 640x360. What a machine makes of it differs; it is
// only the first guess, for the next frames are measured too.
constexpr std::array kPresetCosts = {1.0, 2.0, 3.5, 8.0};
constexpr double kFixed = 0.5;

double cost_of(std::size_t preset, double scale) {
    return kPresetCosts[preset] * (kFixed + (1 - kFixed) * scale * scale);
}

}  // namespace

BudgetLadder ladder_of_presets(const std::string& best) {
    const auto found = std::ranges::find(kPresetNames, best);
    const auto top = static_cast<std::size_t>(found - kPresetNames.begin());
    BudgetLadder ladder;
    ladder.rungs.front().preset = best;
    if (found == kPresetNames.end()) {
        return ladder;
    }
    double least = cost_of(top, 1);
    for (std::size_t below = 0; below <= top; ++below) {
        const std::size_t preset = top - below;
        const std::size_t first = below == 0 ? 1 : 0;
        const std::size_t last = preset == 0 ? kScales.size() : kScalesOfBest;
        for (std::size_t i = first; i < last; ++i) {
            const double cost = cost_of(preset, kScales[i]);
            if (cost < least) {
                least = cost;
                ladder.rungs.push_back(
                    {.name = fmt::format("{}, {:.0f} %", kPresetNames[preset], 100 * kScales[i]),
                     .preset = std::string(kPresetNames[preset]),
                     .set = {},
                     .scale = kScales[i],
                     .cost = {cost / cost_of(top, 1)}});
            }
        }
    }
    return ladder;
}

void add_smaller_pictures(BudgetLadder& ladder, std::size_t pixels) {
    const BudgetRung whole = ladder.rungs.back();
    for (const double scale : kScales) {
        if (scale < 1) {
            BudgetRung rung = whole;
            rung.name = fmt::format("{:.0f} % of the picture's width", 100 * scale);
            rung.scale = scale;
            if (pixels < rung.cost.size()) {
                rung.cost[pixels] *= scale * scale;
            }
            ladder.rungs.push_back(std::move(rung));
        }
    }
}

}  // namespace lanthorn
