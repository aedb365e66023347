#include "gi_module/techniques/emc/maps/surroundings.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

namespace {

constexpr std::size_t kMostLamps = 7;
constexpr double kLampsLight = 0.95;
constexpr float kAlone = 2.5f;  // diagonals
constexpr float kOpen = 4;
constexpr float kWalls = 0.05f;  // diagonals
constexpr float kAnyWorld = 64;
constexpr double kNearShare = 0.4;  // of the solid angle of what an eye sees
constexpr float kNear = 4;          // times the distance within which that lies

float distance_to(const Aabb& box, const vec3& p) {
    return glm::length(glm::max(glm::max(box.lower - p, p - box.upper), vec3(0)));
}

double area_of(std::span<const vec3> polygon) {
    vec3 sum(0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        sum += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    }
    return 0.5 * static_cast<double>(glm::length(sum));
}

// What of a polygon lies on the side of an axis' plane where sign * (p[axis] - at) <= 0 (Sutherland and
// Hodgman 1974).
std::vector<vec3> cut(const std::vector<vec3>& polygon, int axis, float at, float sign) {
    std::vector<vec3> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const float beyond_a = sign * (a[axis] - at), beyond_b = sign * (b[axis] - at);
        if (beyond_a <= 0) {
            result.push_back(a);
        }
        if ((beyond_a < 0 && beyond_b > 0) || (beyond_a > 0 && beyond_b < 0)) {
            result.push_back(glm::mix(a, b, beyond_a / (beyond_a - beyond_b)));
        }
    }
    return result;
}

bool apart(const Aabb& a, const Aabb& b) {
    return glm::any(glm::greaterThan(a.lower, b.upper)) || glm::any(glm::lessThan(a.upper, b.lower));
}

// Whether fewer triangles lie beyond `box`, of those that are smaller than it, than reach into it, or nearly:
// its walls have outsides.
bool is_alone(const FrameScene& scene, const Aabb& inside_of_walls) {
    const vec3 walls(kWalls * inside_of_walls.diagonal());
    const Aabb box{inside_of_walls.lower - walls, inside_of_walls.upper + walls};
    std::size_t inside = 0, beyond = 0;
    for (const Instance& instance : scene.instances) {
        if (scene.material(instance).alpha_mode == AlphaMode::blend) {
            continue;
        }
        const InstanceShape shape(scene, instance);
        const std::span<const std::uint32_t> indices = shape.indices();
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            Aabb triangle;
            for (std::size_t k = i; k < i + 3; ++k) {
                triangle.add(vec3(instance.transform * vec4(shape.position(indices[k]), 1)));
            }
            if (!apart(triangle, box)) {
                ++inside;
            } else if (triangle.diagonal() < box.diagonal()) {
                ++beyond;
            }
        }
    }
    return beyond < inside;
}

// Whether what is seen beyond `box` begins well away from it.
bool ends_with(const Aabb& box, std::span<const vec3> eyes, std::span<const Sight> sights) {
    const vec3 margin(0.01f * box.diagonal());
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        for (const Seen& seen : sights[i]) {
            const vec3 p = eyes[i] + seen.direction * seen.distance;
            const bool beyond = glm::any(glm::lessThan(p, box.lower - margin)) ||
                                glm::any(glm::greaterThan(p, box.upper + margin));
            if (beyond && seen.distance < 2 * box.diagonal()) {
                return false;
            }
        }
    }
    return true;
}

}  // namespace

bool too_large(const Aabb& near, const Aabb& bulk) {
    return kAlone * near.diagonal() >= bulk.diagonal();
}

bool may_have_surroundings(const FrameScene& scene, const Aabb& bulk) {
    return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
        const float scale = distance_to(instance.bounds, scene.camera.position) + instance.bounds.diagonal();
        return !instance.bounds.empty() && kAlone * scale < bulk.diagonal();
    });
}

std::vector<vec3> eyes_of_surroundings(const FrameScene& scene) {
    struct Lamp {
        vec3 position;
        double light;
    };
    const vec3 eye = scene.camera.position;
    std::vector<Lamp> lamps;
    double all = 0;
    for (const LightInstance& lamp : scene.lights) {
        if (lamp.light.type == LightType::directional || !(lamp.light.intensity > 0)) {
            continue;
        }
        // A power more than light falls by: lamps that are spread over a plain without end have a sum.
        const double d = std::max(static_cast<double>(glm::distance(lamp.position, eye)), 1e-9);
        lamps.push_back({lamp.position, static_cast<double>(lamp.light.intensity) / (d * d * d)});
        all += lamps.back().light;
    }
    std::ranges::stable_sort(lamps, std::greater(), &Lamp::light);
    std::vector<vec3> eyes = {eye};
    double light = 0;
    for (std::size_t i = 0; i < std::min(lamps.size(), kMostLamps) && light <= kLampsLight * all; ++i) {
        eyes.push_back(lamps[i].position);
        light += lamps[i].light;
    }
    return eyes;
}

Aabb seen_near(std::span<const vec3> eyes, std::span<const Sight> sights) {
    Aabb box;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        box.add(eyes[i]);
        Sight sight = sights[i];
        std::ranges::sort(sight, {}, &Seen::distance);
        double all = 0;
        for (const Seen& seen : sight) {
            all += static_cast<double>(seen.solid_angle);
        }
        double nearer = 0;
        float reach = std::numeric_limits<float>::infinity();
        for (const Seen& seen : sight) {
            nearer += static_cast<double>(seen.solid_angle);
            if (nearer >= kNearShare * all && reach == std::numeric_limits<float>::infinity()) {
                reach = kNear * seen.distance;
            }
            if (seen.distance <= reach) {
                box.add(eyes[i] + seen.direction * seen.distance);
            }
        }
    }
    return box;
}

Aabb surroundings(const FrameScene& scene, std::span<const vec3> eyes, std::span<const Sight> sights,
                  const Aabb& bulk) {
    const Aabb box = seen_near(eyes, sights);
    const float times = box.diagonal() > 0 ? bulk.diagonal() / box.diagonal() : 0;
    const bool closed = ends_with(box, eyes, sights);
    const bool local = times > kAnyWorld || (times > (closed ? kAlone : kOpen) && is_alone(scene, box));
    return local ? box : Aabb();
}

Aabb find_surroundings(const FrameScene& scene, const render::GpuScene& gpu_scene, const Aabb& bulk,
                       CoverageMeter& meter) {
    if (!may_have_surroundings(scene, bulk)) {
        return {};
    }
    const auto sights = [&](const std::vector<vec3>& from) {
        std::vector<int> all(from.size());
        std::iota(all.begin(), all.end(), 0);
        meter.place(from);
        meter.draw(scene, gpu_scene, all);
        return meter.sights();
    };
    const std::vector<vec3> eyes = eyes_of_surroundings(scene);
    const std::vector<vec3> camera = {eyes[0]};
    return too_large(seen_near(camera, sights(camera)), bulk) ? Aabb()
                                                              : surroundings(scene, eyes, sights(eyes), bulk);
}

double area_within(const FrameScene& scene, const Aabb& box) {
    double sum = 0;
    for (const Instance& instance : scene.instances) {
        if (apart(instance.bounds, box) || scene.material(instance).alpha_mode == AlphaMode::blend) {
            continue;
        }
        const InstanceShape shape(scene, instance);
        const std::span<const std::uint32_t> indices = shape.indices();
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            std::vector<vec3> polygon;
            for (std::size_t k = i; k < i + 3; ++k) {
                polygon.emplace_back(instance.transform * vec4(shape.position(indices[k]), 1));
            }
            for (int axis = 0; axis < 3; ++axis) {
                polygon = cut(polygon, axis, box.upper[axis], 1);
                polygon = cut(polygon, axis, box.lower[axis], -1);
            }
            sum += area_of(polygon);
        }
    }
    return sum;
}

}  // namespace lanthorn::gi
