#include "lanthorn/gi/quality_ladder.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "engine/runtime/budget_ladders.h"
#include "gi_module/shadow_rungs.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

namespace {

struct PassGroup {
    std::string_view pass;
    CostGroup group;
    std::string_view within = {};  // a pass that it is a part of, of another group
};

// Passes within these are theirs.
constexpr std::array kPasses = {
    PassGroup{"gather", CostGroup::gather},      PassGroup{"filter", CostGroup::filter},
    PassGroup{"lit_maps", CostGroup::lit_maps},  PassGroup{"lit_photons", CostGroup::photons, "lit_maps"},
    PassGroup{"upsampling", CostGroup::pixels},  PassGroup{"specular", CostGroup::pixels},
    PassGroup{"gbuffer", CostGroup::pixels},     PassGroup{"direct", CostGroup::pixels},
    PassGroup{"air", CostGroup::pixels},         PassGroup{"composite", CostGroup::pixels},
    PassGroup{"light_maps", CostGroup::shadows},
};

CostGroup group_of(std::string_view pass) {
    const auto found = std::ranges::find(kPasses, pass, &PassGroup::pass);
    return found != kPasses.end() ? found->group : CostGroup::rest;
}

}  // namespace

BudgetLadder quality_ladder(const Settings& settings, ivec2 size, bool pixels) {
    const TechniqueEntry& technique = technique_entry(gi_settings(settings).technique);
    BudgetLadder ladder;
    if (technique.ladder != nullptr) {
        ladder = technique.ladder(settings, size);
    } else {
        // Until frames have been timed: a lantern is carried.
        ladder.shares.assign(kCostGroups, 0);
        ladder.shares[static_cast<std::size_t>(CostGroup::pixels)] = 0.5;
        ladder.shares[static_cast<std::size_t>(CostGroup::shadows)] = 0.3;
        ladder.shares[static_cast<std::size_t>(CostGroup::rest)] = 0.2;
        ladder.rungs.front().cost.assign(kCostGroups, 1);
    }
    if (ladder.rungs.size() == 1) {  // nothing of the technique's own can be spared
        add_coarser_shadows(ladder, settings, size.y, static_cast<std::size_t>(CostGroup::shadows));
    }
    if (pixels) {
        add_smaller_pictures(ladder, static_cast<std::size_t>(CostGroup::pixels));
    }
    return ladder;
}

std::vector<double> group_costs(std::span<const gpu::PassTimer::Span> passes, double frame_ms,
                                bool processor) {
    std::vector<double> groups(kCostGroups);
    double known = 0;
    for (const gpu::PassTimer::Span& span : passes) {
        const auto found = std::ranges::find(kPasses, span.name, &PassGroup::pass);
        if (found == kPasses.end()) {
            continue;
        }
        const double ms = processor ? span.cpu_ms : span.ms;
        groups[static_cast<std::size_t>(found->group)] += ms;
        if (found->within.empty()) {
            known += ms;
        } else {
            groups[static_cast<std::size_t>(group_of(found->within))] -= ms;
        }
    }
    groups[static_cast<std::size_t>(CostGroup::rest)] = std::max(0.0, frame_ms - known);
    for (double& group : groups) {
        group = std::max(group, 0.0);
    }
    return groups;
}

}  // namespace lanthorn::gi
