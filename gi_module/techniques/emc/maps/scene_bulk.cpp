#include "gi_module/techniques/emc/maps/scene_bulk.h"

#include <algorithm>
#include <vector>

#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

namespace {

constexpr double kShare = 0.99;  // of the area
constexpr float kReach = 4;      // radii

struct Weighted {
    float value;
    double area;
};

// The smallest value at or below which `share` of the area lies.
float quantile(std::vector<Weighted>& values, double share) {
    std::ranges::sort(values, {}, &Weighted::value);
    double total = 0;
    for (const Weighted& v : values) {
        total += v.area;
    }
    double below = 0;
    for (const Weighted& v : values) {
        below += v.area;
        if (below >= share * total) {
            return v.value;
        }
    }
    return values.empty() ? 0.0f : values.back().value;
}

}  // namespace

Aabb scene_bulk(const FrameScene& scene) {
    struct Triangle {
        vec3 centroid;
        Aabb bounds;
        double area;
    };
    std::vector<Triangle> triangles;
    for (const Instance& instance : scene.instances) {
        if (scene.material(instance).alpha_mode == AlphaMode::blend) {
            continue;  // blended surfaces take no part
        }
        const InstanceShape shape(scene, instance);
        const auto corner = [&](std::size_t i) {
            return vec3(instance.transform * vec4(shape.position(shape.indices()[i]), 1));
        };
        for (std::size_t i = 0; i + 2 < shape.indices().size(); i += 3) {
            const vec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
            Triangle t{(a + b + c) / 3.0f, {}, 0.5 * glm::length(glm::cross(b - a, c - a))};
            t.bounds.add(a);
            t.bounds.add(b);
            t.bounds.add(c);
            triangles.push_back(t);
        }
    }
    std::vector<Weighted> values(triangles.size());
    vec3 middle(0);
    for (int axis = 0; axis < 3; ++axis) {
        std::ranges::transform(triangles, values.begin(), [&](const Triangle& t) {
            return Weighted{t.centroid[axis], t.area};
        });
        middle[axis] = quantile(values, 0.5);
    }
    const auto reach = [&](const Triangle& t) {  // of its farthest point, at most
        return glm::length(glm::max(glm::abs(t.bounds.lower - middle), glm::abs(t.bounds.upper - middle)));
    };
    std::ranges::transform(triangles, values.begin(), [&](const Triangle& t) {
        return Weighted{reach(t), t.area};
    });
    const float radius = quantile(values, kShare);
    Aabb bulk;
    bool strays = false;
    for (const Triangle& t : triangles) {
        if (reach(t) <= kReach * radius) {
            bulk.add(t.bounds);
        } else {
            strays = true;
        }
    }
    return strays && !bulk.empty() ? bulk : scene.bounds;
}

}  // namespace lanthorn::gi
