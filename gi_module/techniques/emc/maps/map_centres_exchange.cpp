// The progressive update of the centres: a look at the candidates, and what is exchanged after it.
#include <algorithm>
#include <iterator>
#include <utility>

#include "gi_module/techniques/emc/maps/map_centres.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

constexpr double kWorthwhile = 5e-4;  // of the largest area: an exchange that gains less is not made

}  // namespace

// Candidates are those that the camera reaches. Where these are more than there have been, reserved centres,
// which come after them, have other numbers.
void MapCentres::take_reached(const FrameScene& scene, const render::GpuScene& gpu_scene,
                              const GiSettings& settings) {
    const std::vector<bool> used = candidates_in_use();
    const int before = static_cast<int>(candidates_.size());
    near_.make_room(candidates_);
    const int more = static_cast<int>(candidates_.size()) - before;
    std::vector<bool> kept = used;
    kept.resize(candidates_.size(), false);
    near_.take(scene, candidates_, std::move(kept));
    if (more > 0) {
        for (std::vector<int>* members : {&selected_, &judged_}) {
            std::ranges::for_each(*members, [&](int& v) { v += v >= before ? more : 0; });
        }
        draw_candidates(scene, gpu_scene, settings);
    }
}

void MapCentres::look(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
                      int share, int shares) {
    if (share == 0) {
        looked_at_ = 0;
        if (many_rooms()) {
            take_reached(scene, gpu_scene, settings);
            for (std::size_t i = 0; i < candidates_.size(); ++i) {
                meter_.move(static_cast<int>(i), candidates_[i]);
            }
        } else {
            replace_closed(settings);
        }
    }
    const std::vector<int> candidates = share_of(share, shares, settings);
    if (!candidates.empty()) {
        std::vector<int> seen = candidates;
        for (std::size_t r = 0; r < reserved_.size() && share + 1 == shares; ++r) {
            seen.push_back(static_cast<int>(candidates_.size() + r));
        }
        meter_.draw(scene, gpu_scene, seen, share);
    }
    const std::vector<int> before = range(std::exchange(ask_again_, false) ? looked_at_ : 0);
    looked_at_ += static_cast<int>(candidates.size());
    share_ = Asked{share == 0, candidates, unselected(before)};
    std::ranges::copy(unselected(candidates), std::back_inserter(share_->unselected));
    for (const std::vector<int>* viewers : {&share_->candidates, &share_->unselected}) {
        if (!viewers->empty()) {
            meter_.ask(*viewers, viewers == &share_->candidates ? std::vector<int>() : selected_);
        }
    }
}

void MapCentres::take_answers() {
    if (share_) {
        const Asked share = std::move(*share_);
        share_.reset();
        if (share.first) {
            look_.begin(candidates_.size());
        }
        if (!share.candidates.empty()) {
            const std::vector<Coverage> found = meter_.take();
            for (std::size_t i = 0; i < found.size(); ++i) {
                const int v = share.candidates[i];
                look_.found(v, found[i].area, usable_area(found[i], v), !open(found[i]));
            }
        }
        if (!share.unselected.empty()) {
            const std::vector<Coverage> found = meter_.take();
            for (std::size_t i = 0; i < found.size(); ++i) {
                const int v = share.unselected[i];
                look_.found_new(v, found[i].area, usable_area(found[i], v));
            }
        }
    }
    own_.clear();
    if (!larger_.empty()) {
        own_ = usable_areas(meter_.take(), larger_);
        judged_ = std::exchange(larger_, {});
    }
}

void MapCentres::ask() {
    statistics_.coverage = look_.coverage();
    largest_ = look_.largest();
    const int candidate = look_.best();
    if (candidate >= 0 && look_.gain(candidate) >= 0 &&
        std::ranges::find(selected_, candidate) == selected_.end()) {
        larger_ = selected_;
        larger_.push_back(candidate);
        meter_.ask(larger_, larger_);
    }
}

MapCentres::Changes MapCentres::exchange(const GiSettings& settings) {
    ++statistics_.updates;
    // What was asked of other members is not answered; reserved ones may have joined.
    std::vector<int> asked = judged_;
    if (own_.empty() || selected_.size() + 1 < asked.size() ||
        !std::equal(asked.begin(), asked.end() - 1, selected_.begin())) {
        return {};
    }
    const int candidates = static_cast<int>(candidates_.size());
    Changes changes;
    const int k = settings.of<EmcSettings>().count;
    if (static_cast<int>(selected_.size() - reserved_.size()) < k &&
        is_to_grow(judged_, own_, candidates, negligible_area(settings) * largest_)) {
        changes.added = true;
        selected_.push_back(judged_.back());
    } else {
        asked.pop_back();
        const Exchange exchange =
            exchange_for(asked, judged_.back(), candidates,
                         [&](const std::vector<int>&, const std::vector<int>&) { return own_; });
        const auto removed = std::ranges::find(judged_, exchange.removed) - judged_.begin();
        const double gain = own_.back() - own_[static_cast<std::size_t>(removed)];
        if (exchange.none() || !(gain > kWorthwhile * largest_)) {
            return {};
        }
        changes.faded = static_cast<int>(std::ranges::find(selected_, exchange.removed) - selected_.begin());
        if (many_rooms()) {
            changes.replaced = replace_left_behind(exchange);
        }
        selected_[static_cast<std::size_t>(changes.faded)] = exchange.added;
    }
    // The look under way is to know.
    ask_again_ = true;
    std::ranges::for_each(selected_, [&](int v) { look_.joined(v); });
    return changes;
}

// Members of C that the camera does not reach any more need not wait for a round each: those that see what
// neither C nor each other sees take their places, and nobody sees it, so nothing fades.
std::vector<int> MapCentres::replace_left_behind(const Exchange& exchange) {
    std::vector<int> replaced;
    std::vector<int> added = {exchange.added};
    for (std::size_t place = 0; place < selected_.size(); ++place) {
        if (selected_[place] == exchange.removed ||
            !near_.left_behind(static_cast<std::size_t>(selected_[place]))) {
            continue;
        }
        int best = -1;
        for (int v = 0; v < static_cast<int>(look_.size()); ++v) {
            const bool apart = std::ranges::none_of(
                added, [&](int o) { return o == v || near_.pool().in_sight(centre(o), centre(v)); });
            const bool better = best < 0 || look_.gain(v) > look_.gain(best);
            if (look_.gain(v) > 0 && better && !near_.left_behind(static_cast<std::size_t>(v)) && apart &&
                std::ranges::find(selected_, v) == selected_.end()) {
                best = v;
            }
        }
        if (best < 0) {
            break;
        }
        added.push_back(best);
        selected_[place] = best;
        replaced.push_back(static_cast<int>(place));
    }
    return replaced;
}

}  // namespace lanthorn::gi
