#include "gi_module/techniques/emc/maps/selection.h"

#include <algorithm>

namespace lanthorn::gi {

namespace {

std::vector<int> others(int candidates, const std::vector<int>& selected) {
    std::vector<int> result;
    for (int v = 0; v < candidates; ++v) {
        if (std::ranges::find(selected, v) == selected.end()) {
            result.push_back(v);
        }
    }
    return result;
}

}  // namespace

std::vector<int> greedy_selection(int candidates, int k, double negligible, const MeasureCoverage& measure) {
    std::vector<int> selected;
    double first_area = 0;
    while (static_cast<int>(selected.size()) < k) {
        const std::vector<int> viewers = others(candidates, selected);
        if (viewers.empty()) {
            break;
        }
        const std::vector<double> areas = measure(viewers, selected);
        const auto best = std::ranges::max_element(areas);
        if (selected.empty()) {
            first_area = *best;
        }
        if (!(*best > negligible * first_area)) {
            break;
        }
        selected.push_back(viewers[static_cast<std::size_t>(best - areas.begin())]);
    }
    return selected;
}

Exchange exchange_for(std::vector<int>& selected, int added, int candidates, const MeasureCoverage& measure) {
    std::vector<int> larger = selected;
    larger.push_back(added);
    const std::vector<double> own = measure(larger, larger);
    // Ties (say, a still scene of which everything is covered twice) go to the newcomer, so that nothing is
    // exchanged in vain.
    const std::size_t none = larger.size();
    std::size_t least = added < candidates ? none - 1 : none;
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (larger[i] < candidates && (least == none || own[i] < own[least])) {
            least = i;
        }
    }
    if (least == none) {
        return {};
    }
    const int removed = larger[least];
    if (removed != added) {
        selected[least] = added;
    }
    return {added, removed};
}

bool is_to_grow(const std::vector<int>& larger, const std::vector<double>& own, int candidates,
                double negligible) {
    for (std::size_t i = 0; i < larger.size(); ++i) {
        if (larger[i] < candidates && !(own[i] > negligible)) {
            return false;
        }
    }
    return true;
}

Exchange update_step(std::vector<int>& selected, int candidates, const MeasureCoverage& measure) {
    const std::vector<int> viewers = others(candidates, selected);
    if (viewers.empty() || selected.empty()) {
        return {};
    }
    const std::vector<double> gains = measure(viewers, selected);
    const int added = viewers[static_cast<std::size_t>(std::ranges::max_element(gains) - gains.begin())];
    return exchange_for(selected, added, candidates, measure);
}

int refine_until_stable(std::vector<int>& selected, int candidates, int limit,
                        const MeasureCoverage& measure) {
    int steps = 0;
    while (steps < limit) {
        ++steps;
        if (update_step(selected, candidates, measure).none()) {
            break;
        }
    }
    return steps;
}

}  // namespace lanthorn::gi
