#include "gi_module/techniques/vertex-map/area_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kLeaf = 4;  // triangles

float angle_between(const vec3& a, const vec3& b) {
    return std::acos(glm::clamp(glm::dot(a, b), -1.0f, 1.0f));
}

}  // namespace

AreaTree::AreaTree(std::span<const SurfaceTriangle> triangles) {
    order_.resize(triangles.size());
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(triangles.size());
    if (!triangles.empty()) {
        build(triangles, 0, static_cast<std::uint32_t>(triangles.size()));
    }
}

std::uint32_t AreaTree::build(std::span<const SurfaceTriangle> triangles, std::uint32_t first,
                              std::uint32_t end) {
    const auto own = static_cast<std::uint32_t>(nodes_.size());
    Node node;
    dvec3 middle(0);
    dvec3 normal(0);
    double area = 0;
    Aabb middles;
    for (std::uint32_t i = first; i < end; ++i) {
        const SurfaceTriangle& t = triangles[order_[i]];
        const double weight = static_cast<double>(t.area);
        middle += weight * dvec3(t.middle);
        normal += weight * dvec3(t.normal);
        area += weight;
        middles.add(t.middle);
    }
    node.area = static_cast<float>(area);
    node.middle = vec3(middle / area);
    node.normal = glm::length(normal) > 1e-6 * area ? vec3(glm::normalize(normal)) : vec3(0, 1, 0);
    for (std::uint32_t i = first; i < end; ++i) {
        const SurfaceTriangle& t = triangles[order_[i]];
        node.radius = std::max(node.radius, glm::distance(t.middle, node.middle) + t.radius);
        node.cone = std::max(node.cone, angle_between(t.normal, node.normal));
    }
    const bool leaf = end - first <= kLeaf;
    node.first = leaf ? first : 0;
    node.count = leaf ? end - first : 0;
    nodes_.push_back(node);
    if (!leaf) {
        const vec3 size = middles.size();
        const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t half = first + (end - first) / 2;
        std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + end,
                         [&](std::uint32_t a, std::uint32_t b) {
                             const float p = triangles[a].middle[axis], q = triangles[b].middle[axis];
                             return p < q || (p == q && a < b);
                         });
        build(triangles, first, half);
        const std::uint32_t second = build(triangles, half, end);
        nodes_[own].first = second;
    }
    return own;
}

AreaTree::Agreement AreaTree::agreement(const Node& node, const vec3& normal, bool both_sides) {
    const float most = std::acos(kSameSurface);
    const auto of = [&](const vec3& n) {
        const float off = angle_between(node.normal, n);
        return off + node.cone < most    ? Agreement::all
               : off - node.cone >= most ? Agreement::none
                                         : Agreement::some;
    };
    const Agreement front = of(normal);
    return !both_sides || front != Agreement::none ? front : of(-normal);
}

// As if its area were spread evenly over the distances that it lies at.
void AreaTree::add_whole(const Node& node, float distance, float reach, Areas& areas) {
    constexpr float kSpread = 0.6f;  // of the radius, where most of a disc's area lies
    const float spread = std::max(kSpread * node.radius, 1e-30f);
    for (std::size_t k = SurfaceShares::kSteps; k-- > 0;) {
        const float share = 0.5f + 0.5f * (reach * SurfaceShares::step(k) - distance) / spread;
        if (!(share > 0)) {
            return;
        }
        areas[k] += node.area * std::min(share, 1.0f);
    }
}

}  // namespace lanthorn::gi
