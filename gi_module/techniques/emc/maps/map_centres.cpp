#include "gi_module/techniques/emc/maps/map_centres.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "engine/gpu/pass_end.h"
#include "gi_module/shared/plan_rules.h"
#include "gi_module/techniques/emc/maps/candidates.h"
#include "gi_module/techniques/emc/maps/progressive_update.h"
#include "gi_module/techniques/emc/maps/scene_bulk.h"
#include "gi_module/techniques/emc/maps/surroundings.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

constexpr int kRefinementLimit = 16;
constexpr float kMargin = 0.25f;  // of their diagonal, that the camera may be off its surroundings

double total_area(const std::vector<Coverage>& seen) {
    return std::accumulate(seen.begin(), seen.end(), 0.0,
                           [](double sum, const Coverage& c) { return sum + c.area; });
}

// The share of what candidates see that some member of C sees.
double coverage_of(double all, double missed) {
    return all > 0 ? 1.0 - missed / all : 0.0;
}

}  // namespace

std::vector<int> MapCentres::range(int count) {
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

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
        gpu::PassEnd::tell();
        for (std::size_t i = 0; i < points.size() && static_cast<int>(candidates_.size()) < wanted; ++i) {
            (open(seen[i]) ? candidates_ : in_solids).push_back(points[i]);
        }
    }
    if (candidates_.empty()) {
        // Nothing is in the open (a scene seen from its backs alone): any centre is better than no light.
        in_solids.resize(std::min(in_solids.size(), static_cast<std::size_t>(wanted)));
        candidates_ = in_solids;
    }
    reserved_.clear();
    draw_candidates(scene, gpu_scene, settings);
}

void MapCentres::draw_candidates(const FrameScene& scene, const render::GpuScene& gpu_scene,
                                 const GiSettings& settings) {
    std::vector<vec3> centres = candidates_;
    centres.insert(centres.end(), reserved_.begin(), reserved_.end());
    centres.resize(candidates_.size() + kMostReserved + kTrials, vec3(0));
    meter_.place(centres);
    const int shares = ProgressiveUpdate::shares(settings.of<EmcSettings>().update_interval);
    for (int share = 0; share < shares; ++share) {
        meter_.draw(scene, gpu_scene, share_of(share, shares, settings), share);
        gpu::PassEnd::tell();
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

std::vector<vec3> MapCentres::selected_centres() const {
    std::vector<vec3> centres;
    for (const int v : selected_) {
        centres.push_back(centre(v));
    }
    return centres;
}

MeasureCoverage MapCentres::open_area() {
    return [this](const std::vector<int>& viewers, const std::vector<int>& selected) {
        std::vector<double> areas = usable_areas(meter_.measure(viewers, selected), viewers);
        gpu::PassEnd::tell();
        return areas;
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
    return many_rooms() ? in_the_open(coverage, diagonal, static_cast<double>(near_.pool().cell() / diagonal))
                        : in_the_open(coverage, diagonal);
}

double MapCentres::usable_area(const Coverage& coverage, int candidate) const {
    const double area = coverage.area * near_.weight(static_cast<std::size_t>(candidate));
    return open(coverage) ? area : area * 1e-6;
}

double MapCentres::negligible_area(const GiSettings& settings) {
    constexpr double kNegligible = 1e-4;
    constexpr double kNone = -1;  // one that adds nothing is drawn, too
    return settings.of<PlanRules>().count ? kNegligible : kNone;
}

void MapCentres::choose_maps(const GiSettings& settings) {
    const MeasureCoverage measure = open_area();
    const int available = static_cast<int>(candidates_.size());
    selected_ =
        greedy_selection(available, settings.of<EmcSettings>().count, negligible_area(settings), measure);
    statistics_.refinement_steps = refine_until_stable(selected_, available, kRefinementLimit, measure);
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
    near_.carry(by);
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
        near_.leave();
        result.lost = true;
        return result;
    }
    if (!many_rooms()) {
        return result;
    }
    result.changed = near_.follow(scene, result.carried != vec3(0), settings.of<EmcSettings>().candidates);
    if (scene.changes.camera) {
        result.lost = near_.lost(selected_centres());
    }
    return result;
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
    if (const int best = look_.best(); best >= 0) {
        use(best);
    }
    return used;
}

void MapCentres::replace_closed(const GiSettings& settings) {
    const std::vector<bool> used = candidates_in_use();
    for (const std::size_t v : look_.closed()) {
        if (!used[v]) {
            candidates_[v] = candidate_points(bulk_, next_point_++, 1, settings.seed).front();
            meter_.move(static_cast<int>(v), candidates_[v]);
        }
    }
}

void MapCentres::select(const FrameScene& scene, const render::GpuScene& gpu_scene,
                        const GiSettings& settings, bool elsewhere) {
    if (!elsewhere || !many_rooms()) {
        find_surroundings(scene, gpu_scene);
        near_.forget();
        choose_candidates(scene, gpu_scene, settings);
        choose_maps(settings);
        gpu::PassEnd::tell();
        near_.find(scene, bulk_, selected_centres(), settings.seed);
        if (many_rooms()) {
            candidates_.clear();
        }
        motion_.watch(scene, bulk_);
    }
    look_.forget();
    if (many_rooms()) {
        near_.reach(scene.camera.position, settings.of<EmcSettings>().candidates);
        selected_.clear();
        larger_.clear();
        reserved_.clear();
        near_.make_room(candidates_);
        near_.take(scene, candidates_, candidates_in_use());
        draw_candidates(scene, gpu_scene, settings);
        choose_maps(settings);
        near_.lost(selected_centres());
    }
    const int available = static_cast<int>(candidates_.size());
    ++statistics_.updates;
    const std::vector<int> others = unselected(range(available));
    const double all = total_area(meter_.measure(range(available), {}));
    const double missed = others.empty() ? 0 : total_area(meter_.measure(others, selected_));
    statistics_.coverage = coverage_of(all, missed);
    meter_.forget();
    share_.reset();
    larger_.clear();
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
