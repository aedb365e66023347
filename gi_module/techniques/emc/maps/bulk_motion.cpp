#include "gi_module/techniques/emc/maps/bulk_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "gi_module/techniques/emc/maps/instance_key.h"

namespace lanthorn::gi {

namespace {

constexpr float kBoxMargin = 0.1f;  // of the box's diagonal
constexpr double kBulk = 0.5;       // of the area: the bulk is more than this
constexpr double kAlike = 0.25;     // of the bulk's motion: how much a thing's may differ from it
constexpr double kBeyond = 0.1;     // of the area, outside the box: then it is given up

float area_of(const Aabb& box) {
    const vec3 size = box.size();
    return box.empty() ? 0.0f : 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

bool finite(const dvec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

struct Moved {
    dvec3 by;
    double area;
};

// Of each axis the middle one by area.
dvec3 middle_of(std::vector<Moved> moved, double area) {
    dvec3 result(0);
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::sort(moved, {}, [axis](const Moved& m) { return m.by[axis]; });
        double below = 0;
        for (const Moved& m : moved) {
            below += m.area;
            if (below >= 0.5 * area) {
                result[axis] = m.by[axis];
                break;
            }
        }
    }
    return result;
}

// How far the bulk moves of things of `area` in all, some of which have moved; 0 if it does not.
dvec3 common_motion(const std::vector<Moved>& moved, double area) {
    double any = 0;
    for (const Moved& m : moved) {
        any += m.area;
    }
    if (!(any > kBulk * area)) {
        return dvec3(0);
    }
    const dvec3 by = middle_of(moved, any);
    double alike = 0;
    for (const Moved& m : moved) {
        alike += glm::distance(m.by, by) <= kAlike * glm::length(by) ? m.area : 0;
    }
    return alike > kBulk * area ? by : dvec3(0);
}

}  // namespace

bool BulkMotion::holds(const Aabb& box) const {
    const vec3 margin(kBoxMargin * box_.diagonal());
    return glm::all(glm::greaterThanEqual(box.lower, box_.lower - margin)) &&
           glm::all(glm::lessThanEqual(box.upper, box_.upper + margin));
}

void BulkMotion::watch(const FrameScene& scene, const Aabb& box) {
    things_.clear();
    box_ = box;
    origin_ = scene.origin;
    area_ = outside_ = 0;
    for (const Instance& instance : scene.instances) {
        if (instance.bounds.empty() || !holds(instance.bounds)) {
            continue;
        }
        const vec3 centre = instance.bounds.centre();
        const float area = area_of(instance.bounds);
        const vec3 middle(glm::inverse(instance.transform) * vec4(centre, 1));
        const dvec3 at = scene.origin + dvec3(vec3(instance.transform * vec4(middle, 1)));
        if (finite(at) && things_.insert({instance_key(instance), {middle, at, area, false}}).second) {
            area_ += static_cast<double>(area);
        }
    }
}

BulkMotion::Step BulkMotion::follow(const FrameScene& scene) {
    std::vector<Moved> moved;
    for (const std::uint32_t i : scene.changes.moved) {
        const Instance& instance = scene.instances[i];
        const auto found = things_.find(instance_key(instance));
        if (found != things_.end()) {
            Thing& thing = found->second;
            const dvec3 at = scene.origin + dvec3(vec3(instance.transform * vec4(thing.middle, 1)));
            const dvec3 by = at - thing.at;
            thing.at = at;
            if (by != dvec3(0) && finite(by)) {
                moved.push_back({by, static_cast<double>(thing.area)});
            }
        }
    }
    Step step;
    step.by = vec3(common_motion(moved, area_) + (origin_ - scene.origin));
    origin_ = scene.origin;
    box_ = {box_.lower + step.by, box_.upper + step.by};
    const auto look = [&](const Instance& instance) {
        const auto found = things_.find(instance_key(instance));
        if (found != things_.end() && found->second.outside == holds(instance.bounds)) {
            Thing& thing = found->second;
            thing.outside = !thing.outside;
            outside_ += thing.outside ? static_cast<double>(thing.area) : -static_cast<double>(thing.area);
        }
    };
    if (step.by != vec3(0)) {
        std::ranges::for_each(scene.instances, look);  // what stays is left behind
    } else {
        std::ranges::for_each(scene.changes.moved, [&](std::uint32_t i) { look(scene.instances[i]); });
    }
    step.apart = outside_ > kBeyond * area_;
    return step;
}

}  // namespace lanthorn::gi
