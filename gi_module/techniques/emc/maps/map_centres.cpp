#include "gi_module/techniques/emc/maps/map_centres.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "gi_module/techniques/emc/maps/candidates.h"
#include "gi_module/techniques/emc/maps/progressive_update.h"
#include "gi_module/techniques/emc/maps/reserved_centres.h"
#include "gi_module/techniques/emc/maps/scene_bulk.h"
#include "gi_module/techniques/emc/maps/surroundings.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

constexpr double kNegligibleArea = 1e-4;  // of the first map's area: a map that adds less is not drawn
constexpr double kWorthwhile = 5e-4;      // of the largest area: an exchange that gains less is not made
constexpr int kRefinementLimit = 16;
// Of reserved centres. After the candidates the meter has those in use and those that are tried.
constexpr int kMostReserved = 2;
constexpr int kTrials = 8;
constexpr int kTrialLook = 10;         // LayeredMaps::update; those before are the shares'
constexpr double kClearance = 0.0015;  // of the diagonal: they may stand in narrow gaps
// Of many rooms.
constexpr double kFewRooms = 0.9;    // of free places, that k maps must see to be enough
constexpr int kNearCentres = 8;      // centres as far as this one count half
constexpr double kUnlit = 0.3;       // what those count that no lamp shines on
constexpr float kMargin = 0.25f;     // of their diagonal, that the camera may be off its surroundings
constexpr double kUnreached = 1e-6;  // what the others count

std::vector<int> range(int count) {
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

double total_area(const std::vector<Coverage>& seen) {
    return std::accumulate(seen.begin(), seen.end(), 0.0,
                           [](double sum, const Coverage& c) { return sum + c.area; });
}

// The share of what candidates see that some member of C sees.
double coverage_of(double all, double missed) {
    return all > 0 ? 1.0 - missed / all : 0.0;
}

double sum(const std::vector<double>& areas) {
    return std::accumulate(areas.begin(), areas.end(), 0.0);
}

}  // namespace

// Where candidates are to be.
void MapCentres::find_surroundings(const FrameScene& scene, const render::GpuScene& gpu_scene) {
    bulk_ = scene_bulk(scene);
    surroundings_ = gi::find_surroundings(scene, gpu_scene, bulk_, meter_);
    bulk_ = surroundings_.empty() ? bulk_ : surroundings_;
    meter_.reach(surroundings_.empty() ? std::numeric_limits<float>::infinity() : 0.5f * bulk_.diagonal());
}

void MapCentres::choose_candidates(const FrameScene& scene, const render::GpuScene& gpu_scene,
                                   const GiSettings& settings) {
    candidates_.clear();
    const int wanted = settings.of<EmcSettings>().candidates;
    std::vector<vec3> in_solids;
    for (int batch = 0; batch < 4 && static_cast<int>(candidates_.size()) < wanted; ++batch) {
        const std::vector<vec3> points = candidate_points(bulk_, batch * wanted, wanted, settings.seed);
        next_point_ = (batch + 1) * wanted;
        meter_.place(points);
        meter_.draw(scene, gpu_scene, range(wanted));
        const std::vector<Coverage> seen = meter_.measure(range(wanted), {});
        for (std::size_t i = 0; i < points.size() && static_cast<int>(candidates_.size()) < wanted; ++i) {
            (open(seen[i]) ? candidates_ : in_solids).push_back(points[i]);
        }
    }
    if (candidates_.empty()) {
        // Nothing is in the open (a scene seen from its backs alone): any centre is better than no light.
        in_solids.resize(std::min(in_solids.size(), static_cast<std::size_t>(wanted)));
        candidates_ = in_solids;
    }
    draw_candidates(scene, gpu_scene, settings);
}

void MapCentres::draw_candidates(const FrameScene& scene, const render::GpuScene& gpu_scene,
                                 const GiSettings& settings) {
    std::vector<vec3> centres = candidates_;
    centres.resize(centres.size() + kMostReserved + kTrials, vec3(0));
    meter_.place(centres);
    reserved_.clear();
    const int shares = ProgressiveUpdate::shares(settings.of<EmcSettings>().update_interval);
    for (int share = 0; share < shares; ++share) {
        meter_.draw(scene, gpu_scene, share_of(share, shares, settings), share);
    }
}

std::vector<int> MapCentres::share_of(int share, int shares, const GiSettings& settings) const {
    const auto [first, end] = ProgressiveUpdate::candidates(
        share, shares, static_cast<int>(candidates_.size()), settings.of<EmcSettings>().count);
    std::vector<int> candidates(static_cast<std::size_t>(end - first));
    std::iota(candidates.begin(), candidates.end(), first);
    return candidates;
}

vec3 MapCentres::centre(int index) const {
    const auto i = static_cast<std::size_t>(index);
    return i < candidates_.size() ? candidates_[i] : reserved_[i - candidates_.size()];
}

MeasureCoverage MapCentres::open_area() {
    return [this](const std::vector<int>& viewers, const std::vector<int>& selected) {
        return usable_areas(meter_.measure(viewers, selected), viewers);
    };
}

std::vector<double> MapCentres::usable_areas(const std::vector<Coverage>& seen,
                                             const std::vector<int>& viewers) const {
    std::vector<double> areas(seen.size());
    for (std::size_t i = 0; i < seen.size(); ++i) {
        areas[i] = usable_area(seen[i], viewers[i]);
    }
    return areas;
}

bool MapCentres::open(const Coverage& coverage) const {
    const float diagonal = bulk_.diagonal();
    // Of many rooms the diagonal says nothing about the size of one.
    return pool_.filled() ? in_the_open(coverage, diagonal, static_cast<double>(pool_.cell() / diagonal))
                          : in_the_open(coverage, diagonal);
}

double MapCentres::usable_area(const Coverage& coverage, int candidate) const {
    const auto i = static_cast<std::size_t>(candidate);
    const double area = coverage.area * (i < weight_.size() ? weight_[i] : 1);
    return open(coverage) ? area : area * 1e-6;
}

void MapCentres::choose_maps(const GiSettings& settings) {
    const MeasureCoverage measure = open_area();
    const int available = static_cast<int>(candidates_.size());
    selected_ = greedy_selection(available, settings.of<EmcSettings>().count, kNegligibleArea, measure);
    statistics_.refinement_steps = refine_until_stable(selected_, available, kRefinementLimit, measure);
}

bool MapCentres::sees_a_map(const vec3& eye) const {
    return std::ranges::any_of(selected_,
                               [&](int v) { return pool_.in_sight(eye, centre(v), pool_.cell()); });
}

bool MapCentres::left_surroundings(const vec3& eye) const {
    const vec3 margin(kMargin * surroundings_.diagonal());
    return glm::any(glm::lessThan(eye, surroundings_.lower - margin)) ||
           glm::any(glm::greaterThan(eye, surroundings_.upper + margin));
}

void MapCentres::carry(const vec3& by) {
    const auto box = [&](Aabb& b) { b = b.empty() ? b : Aabb{b.lower + by, b.upper + by}; };
    box(bulk_);
    box(surroundings_);
    for (std::vector<vec3>* centres : {&candidates_, &reserved_}) {
        std::ranges::for_each(*centres, [&](vec3& c) { c += by; });
    }
    for (std::size_t i = 0; i < candidates_.size() + reserved_.size(); ++i) {
        meter_.move(static_cast<int>(i), centre(static_cast<int>(i)));
    }
    pool_.carry(by);
    eye_ += by;
}

MapCentres::Reach MapCentres::follow(const FrameScene& scene, const GiSettings& settings) {
    Reach result;
    if (scene.changes.geometry) {
        const BulkMotion::Step step = motion_.follow(scene);
        result.apart = step.apart;
        result.carried = step.by;
        if (step.by != vec3(0)) {
            carry(step.by);
        }
    }
    if (!surroundings_.empty() && left_surroundings(scene.camera.position)) {
        pool_ = {};
        result.lost = true;
        return result;
    }
    if (!many_rooms()) {
        return result;
    }
    // What moves along with all rooms is in nobody's way that it was not in before.
    const bool other_ways =
        scene.changes.geometry && result.carried == vec3(0) && pool_.leave_out(scene, scene.changes.moved);
    const vec3 eye = scene.camera.position;
    if (other_ways || glm::distance(eye, eye_) > pool_.cell()) {
        reached_ = pool_.reach(eye, settings.of<EmcSettings>().candidates);
        eye_ = eye;
        result.changed = true;
    }
    if (scene.changes.camera) {
        const bool before = std::exchange(in_sight_, sees_a_map(eye));
        result.lost = before && !in_sight_;
    }
    return result;
}

// What is near counts more, and what lamps shine on: light comes from there.
std::vector<double> MapCentres::weights_of_reached(const FrameScene& scene) const {
    std::vector<double> light(reached_.size(), 0);
    double mean = 0;
    for (std::size_t r = 0; r < reached_.size(); ++r) {
        const vec3 c = pool_.centres()[static_cast<std::size_t>(reached_[r].centre)];
        for (const LightInstance& lamp : scene.lights) {
            const double d = std::max(static_cast<double>(glm::distance(c, lamp.position)),
                                      static_cast<double>(pool_.cell()));
            if (lamp.light.type != LightType::directional &&
                pool_.in_sight(lamp.position, c, 2 * pool_.cell())) {
                light[r] += static_cast<double>(lamp.light.intensity) / (d * d);
            }
        }
        mean += light[r] / static_cast<double>(reached_.size());
    }
    const std::size_t middle = std::min(reached_.size() - 1, static_cast<std::size_t>(kNearCentres));
    const double half = std::max(static_cast<double>(reached_[middle].distance), 1e-9);
    std::vector<double> weights;
    for (std::size_t r = 0; r < reached_.size(); ++r) {
        const double d = static_cast<double>(reached_[r].distance) / half;
        const double lit = mean > 0 ? light[r] / (light[r] + mean) : 0;
        weights.push_back((kUnlit + (1 - kUnlit) * lit) / (1 + d * d));
    }
    return weights;
}

// Those of C, and of the best that may be about to join: they stay where they are.
std::vector<bool> MapCentres::candidates_in_use() const {
    std::vector<bool> used(candidates_.size(), false);
    const auto use = [&](int v) {
        if (v < static_cast<int>(used.size())) {
            used[static_cast<std::size_t>(v)] = true;
        }
    };
    std::ranges::for_each(selected_, use);
    std::ranges::for_each(larger_, use);
    if (const auto best = std::ranges::max_element(gain_); best != gain_.end()) {
        use(static_cast<int>(best - gain_.begin()));
    }
    return used;
}

void MapCentres::replace_closed(const GiSettings& settings) {
    const std::vector<bool> used = candidates_in_use();
    for (std::size_t v = 0; v < std::min(closed_.size(), candidates_.size()); ++v) {
        if (closed_[v] && !used[v]) {
            candidates_[v] = candidate_points(bulk_, next_point_++, 1, settings.seed).front();
            meter_.move(static_cast<int>(v), candidates_[v]);
        }
    }
}

void MapCentres::take_reached(const FrameScene& scene) {
    const std::size_t count = std::max(candidates_.size(), reached_.size());
    if (candidates_.size() < count) {
        candidates_.resize(count, vec3(0));
        pooled_.resize(count, -1);
    }
    const std::vector<double> weights = weights_of_reached(scene);
    std::vector<bool> kept = candidates_in_use();
    weight_.assign(count, kUnreached);
    std::vector<std::size_t> others;
    for (std::size_t r = 0; r < reached_.size(); ++r) {
        const auto at = std::ranges::find(pooled_, reached_[r].centre);
        if (at != pooled_.end()) {
            const auto i = static_cast<std::size_t>(at - pooled_.begin());
            kept[i] = true;
            weight_[i] = weights[r];
        } else {
            others.push_back(r);
        }
    }
    std::size_t i = 0;
    for (const std::size_t r : others) {
        while (i < count && kept[i]) {
            ++i;
        }
        if (i == count) {
            break;
        }
        kept[i] = true;
        pooled_[i] = reached_[r].centre;
        candidates_[i] = pool_.centres()[static_cast<std::size_t>(reached_[r].centre)];
        weight_[i] = weights[r];
    }
}

// Whether k maps show next to all that can be reached from the camera, and from the lamps; if not, a pool of
// centres.
void MapCentres::find_rooms(const FrameScene& scene, const GiSettings& settings) {
    CentrePool pool(scene, bulk_);
    const std::vector<vec3> eye = {scene.camera.position};
    std::vector<vec3> lamps;
    for (const LightInstance& light : scene.lights) {
        lamps.push_back(light.position);
    }
    std::vector<vec3> maps;
    for (const int v : selected_) {
        maps.push_back(centre(v));
    }
    if (pool.seen_share(eye, maps) < kFewRooms || pool.seen_share(lamps, maps) < kFewRooms) {
        pool.fill(settings.seed);
        pool_ = std::move(pool);
        candidates_.clear();
        pooled_.clear();
    }
}

void MapCentres::select(const FrameScene& scene, const render::GpuScene& gpu_scene,
                        const GiSettings& settings, bool elsewhere) {
    if (!elsewhere || !many_rooms()) {
        find_surroundings(scene, gpu_scene);
        pool_ = {};
        weight_.clear();
        choose_candidates(scene, gpu_scene, settings);
        choose_maps(settings);
        find_rooms(scene, settings);
        motion_.watch(scene, bulk_);
    }
    gain_.clear();
    if (many_rooms()) {
        reached_ = pool_.reach(scene.camera.position, settings.of<EmcSettings>().candidates);
        eye_ = scene.camera.position;
        selected_.clear();
        larger_.clear();
        take_reached(scene);
        draw_candidates(scene, gpu_scene, settings);
        choose_maps(settings);
        in_sight_ = sees_a_map(eye_);
    }
    const int available = static_cast<int>(candidates_.size());
    ++statistics_.updates;
    const std::vector<int> others = unselected(range(available));
    const double all = total_area(meter_.measure(range(available), {}));
    const double missed = others.empty() ? 0 : total_area(meter_.measure(others, selected_));
    statistics_.coverage = coverage_of(all, missed);
    closed_.clear();
    meter_.forget();
    share_.reset();
    larger_.clear();
}

void MapCentres::look(const FrameScene& scene, const render::GpuScene& gpu_scene, const GiSettings& settings,
                      int share, int shares) {
    if (share == 0) {
        looked_at_ = 0;
        if (many_rooms()) {
            take_reached(scene);
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
            gain_.assign(candidates_.size(), -1);
            closed_.assign(candidates_.size(), false);
            for (std::vector<double>* areas : {&area_, &missed_, &usable_}) {
                areas->assign(candidates_.size(), 0);
            }
        }
        if (!share.candidates.empty()) {
            const std::vector<Coverage> found = meter_.take();
            for (std::size_t i = 0; i < found.size(); ++i) {
                const auto v = static_cast<std::size_t>(share.candidates[i]);
                area_[v] = found[i].area;
                usable_[v] = usable_area(found[i], share.candidates[i]);
                closed_[v] = !open(found[i]);
            }
        }
        if (!share.unselected.empty()) {
            const std::vector<Coverage> found = meter_.take();
            for (std::size_t i = 0; i < found.size(); ++i) {
                const auto v = static_cast<std::size_t>(share.unselected[i]);
                missed_[v] = found[i].area;
                gain_[v] = usable_area(found[i], share.unselected[i]);
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
    statistics_.coverage = coverage_of(sum(area_), sum(missed_));
    largest_ = usable_.empty() ? 0 : std::ranges::max(usable_);
    const auto best = std::ranges::max_element(gain_);
    const int candidate = static_cast<int>(best - gain_.begin());
    if (best != gain_.end() && *best >= 0 && std::ranges::find(selected_, candidate) == selected_.end()) {
        larger_ = selected_;
        larger_.push_back(candidate);
        meter_.ask(larger_, larger_);
    }
}

MapCentres::Changes MapCentres::exchange(int k) {
    ++statistics_.updates;
    // What was asked of other members is not answered; reserved ones may have joined.
    std::vector<int> asked = judged_;
    if (own_.empty() || selected_.size() + 1 < asked.size() ||
        !std::equal(asked.begin(), asked.end() - 1, selected_.begin())) {
        return {};
    }
    const int candidates = static_cast<int>(candidates_.size());
    Changes changes;
    if (static_cast<int>(selected_.size() - reserved_.size()) < k &&
        is_to_grow(judged_, own_, candidates, kNegligibleArea * largest_)) {
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
    for (const int v : selected_) {
        const auto i = static_cast<std::size_t>(v);
        if (i < gain_.size()) {
            gain_[i] = -1;
            missed_[i] = 0;
        }
    }
    return changes;
}

// Members of C that the camera does not reach any more need not wait for a round each: those that see what
// neither C nor each other sees take their places, and nobody sees it, so nothing fades.
std::vector<int> MapCentres::replace_left_behind(const Exchange& exchange) {
    std::vector<int> replaced;
    std::vector<int> added = {exchange.added};
    for (std::size_t place = 0; place < selected_.size(); ++place) {
        const auto member = static_cast<std::size_t>(selected_[place]);
        if (selected_[place] == exchange.removed || member >= weight_.size() ||
            weight_[member] > kUnreached) {
            continue;
        }
        int best = -1;
        for (std::size_t v = 0; v < gain_.size(); ++v) {
            const auto candidate = static_cast<int>(v);
            const bool apart = std::ranges::none_of(
                added, [&](int o) { return o == candidate || pool_.in_sight(centre(o), centre(candidate)); });
            const bool better = best < 0 || gain_[v] > gain_[static_cast<std::size_t>(best)];
            if (gain_[v] > 0 && better && weight_[v] > kUnreached && apart &&
                std::ranges::find(selected_, candidate) == selected_.end()) {
                best = candidate;
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

MapCentres::Reserved MapCentres::reserve(const FrameScene& scene, const render::GpuScene& gpu_scene,
                                         const GiSettings& settings, const UnseenSurvey& survey) {
    const int most = std::min(settings.of<EmcSettings>().reserved, kMostReserved);
    if (most == 0 || survey.places.empty() || selected_.empty()) {
        return {};
    }
    const int ordinary = static_cast<int>(candidates_.size());
    std::vector<int> viewers;
    for (std::size_t r = 0; r < reserved_.size(); ++r) {
        viewers.push_back(ordinary + static_cast<int>(r));
    }
    const std::vector<vec3> trials = trial_centres(survey, bulk_.diagonal(), kTrials);
    for (std::size_t t = 0; t < trials.size(); ++t) {
        viewers.push_back(ordinary + kMostReserved + static_cast<int>(t));
        meter_.move(viewers.back(), trials[t]);
    }
    meter_.draw(scene, gpu_scene, viewers, kTrialLook);
    std::vector<std::vector<bool>> seen = meter_.sees(viewers, survey.places);
    const std::vector<Coverage> coverage = meter_.measure(viewers, {});
    for (std::size_t v = 0; v < viewers.size(); ++v) {
        if (!in_the_open(coverage[v], bulk_.diagonal(), kClearance)) {
            seen[v].assign(survey.places.size(), false);
        }
    }
    std::vector<vec3> centres = reserved_;
    centres.insert(centres.end(), trials.begin(), trials.end());
    std::size_t in_use = reserved_.size();
    int replaced = -1;
    Reservation chosen = reservation(survey, seen, static_cast<int>(in_use), most);
    const std::size_t before = in_use;
    while (chosen.trial >= 0) {
        replaced = chosen.replaced;
        const std::size_t at = replaced < 0 ? in_use++ : static_cast<std::size_t>(replaced);
        std::swap(centres[at], centres[static_cast<std::size_t>(chosen.trial)]);
        std::swap(seen[at], seen[static_cast<std::size_t>(chosen.trial)]);
        const bool more = static_cast<int>(in_use) < most;
        chosen = more ? reservation(survey, seen, static_cast<int>(in_use), most) : Reservation{};
    }
    if (replaced < 0 && in_use == before) {
        return {};
    }
    reserved_.assign(centres.begin(), centres.begin() + static_cast<std::ptrdiff_t>(in_use));
    viewers.resize(in_use);
    for (std::size_t r = 0; r < in_use; ++r) {
        viewers[r] = ordinary + static_cast<int>(r);
        meter_.move(viewers[r], reserved_[r]);
    }
    meter_.draw(scene, gpu_scene, viewers, kTrialLook);
    ++statistics_.updates;
    if (replaced >= 0) {
        const auto at = std::ranges::find(selected_, ordinary + replaced);
        return {static_cast<int>(at - selected_.begin()), 0};
    }
    selected_.insert(selected_.end(), viewers.begin() + static_cast<std::ptrdiff_t>(before), viewers.end());
    return {-1, static_cast<int>(in_use - before)};
}

std::vector<int> MapCentres::unselected(const std::vector<int>& candidates) const {
    std::vector<int> result;
    std::ranges::copy_if(candidates, std::back_inserter(result),
                         [&](int v) { return std::ranges::find(selected_, v) == selected_.end(); });
    return result;
}

EmcStatistics MapCentres::statistics() const {
    EmcStatistics result = statistics_;
    result.k = static_cast<int>(selected_.size() - reserved_.size());
    result.reserved = static_cast<int>(reserved_.size());
    result.candidates = static_cast<int>(candidates_.size());
    return result;
}

}  // namespace lanthorn::gi
