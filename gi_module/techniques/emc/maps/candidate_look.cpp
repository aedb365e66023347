#include "gi_module/techniques/emc/maps/candidate_look.h"

#include <algorithm>
#include <numeric>

namespace lanthorn::gi {

void CandidateLook::begin(std::size_t candidates) {
    gain_.assign(candidates, -1);
    closed_.assign(candidates, false);
    for (std::vector<double>* areas : {&area_, &missed_, &usable_}) {
        areas->assign(candidates, 0);
    }
}

void CandidateLook::forget() {
    gain_.clear();
    closed_.clear();
}

void CandidateLook::found(int candidate, double area, double usable, bool closed) {
    const auto v = static_cast<std::size_t>(candidate);
    area_[v] = area;
    usable_[v] = usable;
    closed_[v] = closed;
}

void CandidateLook::found_new(int candidate, double area, double usable) {
    const auto v = static_cast<std::size_t>(candidate);
    missed_[v] = area;
    gain_[v] = usable;
}

void CandidateLook::joined(int candidate) {
    const auto v = static_cast<std::size_t>(candidate);
    if (v < gain_.size()) {
        gain_[v] = -1;
        missed_[v] = 0;
    }
}

int CandidateLook::best() const {
    const auto best = std::ranges::max_element(gain_);
    return best != gain_.end() ? static_cast<int>(best - gain_.begin()) : -1;
}

std::vector<std::size_t> CandidateLook::closed() const {
    std::vector<std::size_t> result;
    for (std::size_t v = 0; v < closed_.size(); ++v) {
        if (closed_[v]) {
            result.push_back(v);
        }
    }
    return result;
}

double CandidateLook::coverage() const {
    const double all = std::accumulate(area_.begin(), area_.end(), 0.0);
    const double missed = std::accumulate(missed_.begin(), missed_.end(), 0.0);
    return all > 0 ? 1.0 - missed / all : 0.0;
}

double CandidateLook::largest() const {
    return usable_.empty() ? 0 : std::ranges::max(usable_);
}

}  // namespace lanthorn::gi
