#include "gi_module/techniques/emc/maps/scene_bulk.h"

#include <algorithm>
#include <numeric>
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

// The smallest value at or below which `share` of the area lies. Leaves `values` in another order. O(values):
// a part that cannot hold it is left aside with its sum (Hoare 1961, by weight).
float quantile(std::vector<Weighted>& values, double share) {
    double total = 0;
    for (const Weighted& v : values) {
        total += v.area;
    }
    const double wanted = share * total;
    const auto area_of = [](auto first, auto last) {
        return std::accumulate(first, last, 0.0, [](double sum, const Weighted& v) { return sum + v.area; });
    };
    auto first = values.begin(), last = values.end();
    double below = 0;
    while (last - first > 1) {
        const float a = first->value, b = first[(last - first) / 2].value, c = last[-1].value;
        const float pivot = std::max(std::min(a, b), std::min(std::max(a, b), c));
        const auto equal = std::partition(first, last, [&](const Weighted& v) { return v.value < pivot; });
        const auto above = std::partition(equal, last, [&](const Weighted& v) { return !(pivot < v.value); });
        const double less = area_of(first, equal), same = area_of(equal, above);
        if (below + less >= wanted && equal != first) {
            last = equal;
        } else if (below + less + same >= wanted || above == last) {
            return pivot;
        } else {
            below += less + same;
            first = above;
        }
    }
    return first != last ? first->value : 0.0f;
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
