#include "gi_module/techniques/emc/maps/near_centres.h"

#include <algorithm>
#include <utility>

namespace lanthorn::gi {

namespace {

constexpr double kFewRooms = 0.9;    // of free places, that k maps must see to be enough
constexpr int kNearCentres = 8;      // centres as far as this one count half
constexpr double kUnlit = 0.3;       // what those count that no lamp shines on
constexpr double kUnreached = 1e-6;  // what the others count

}  // namespace

void NearCentres::find(const FrameScene& scene, const Aabb& bulk, const std::vector<vec3>& maps,
                       std::uint32_t seed) {
    CentrePool pool(scene, bulk);
    const std::vector<vec3> eye = {scene.camera.position};
    std::vector<vec3> lamps;
    for (const LightInstance& light : scene.lights) {
        lamps.push_back(light.position);
    }
    if (pool.seen_share(eye, maps) < kFewRooms || pool.seen_share(lamps, maps) < kFewRooms) {
        pool.fill(seed);
        pool_ = std::move(pool);
        pooled_.clear();
    }
}

void NearCentres::forget() {
    leave();
    weight_.clear();
}

void NearCentres::reach(const vec3& eye, int count) {
    reached_ = pool_.reach(eye, count);
    eye_ = eye;
    camera_ = eye;
}

bool NearCentres::follow(const FrameScene& scene, bool carried, int count) {
    // What moves along with all rooms is in nobody's way that it was not in before.
    const bool other_ways = scene.changes.geometry && !carried && pool_.leave_out(scene, scene.changes.moved);
    camera_ = scene.camera.position;
    if (!other_ways && glm::distance(camera_, eye_) <= pool_.cell()) {
        return false;
    }
    reach(camera_, count);
    return true;
}

bool NearCentres::sees_one_of(const std::vector<vec3>& maps) const {
    return std::ranges::any_of(maps,
                               [&](const vec3& map) { return pool_.eye_sees(camera_, map, pool_.cell()); });
}

bool NearCentres::lost(const std::vector<vec3>& maps) {
    const bool before = std::exchange(in_sight_, sees_one_of(maps));
    return before && !in_sight_;
}

void NearCentres::carry(const vec3& by) {
    pool_.carry(by);
    eye_ += by;
}

// What is near counts more, and what lamps shine on: light comes from there.
std::vector<double> NearCentres::weights_of_reached(const FrameScene& scene) const {
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

void NearCentres::make_room(std::vector<vec3>& candidates) {
    if (candidates.size() < reached_.size()) {
        candidates.resize(reached_.size(), vec3(0));
        pooled_.resize(reached_.size(), -1);
    }
}

void NearCentres::take(const FrameScene& scene, std::vector<vec3>& candidates, std::vector<bool> kept) {
    const std::size_t count = candidates.size();
    const std::vector<double> weights = weights_of_reached(scene);
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
        candidates[i] = pool_.centres()[static_cast<std::size_t>(reached_[r].centre)];
        weight_[i] = weights[r];
    }
}

bool NearCentres::left_behind(std::size_t candidate) const {
    return candidate < weight_.size() && weight_[candidate] <= kUnreached;
}

}  // namespace lanthorn::gi
