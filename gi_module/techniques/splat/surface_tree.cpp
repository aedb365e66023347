#include "gi_module/techniques/splat/surface_tree.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kLeaf = 4;

vec3 middle(const std::array<vec3, 3>& t) {
    return (t[0] + t[1] + t[2]) / 3.0f;
}

}  // namespace

SurfaceTree::SurfaceTree(std::vector<std::array<vec3, 3>> triangles) : triangles_(std::move(triangles)) {
    for (const auto& t : triangles_) {
        for (const vec3& p : t) {
            bounds_.add(p);
        }
    }
    if (!triangles_.empty()) {
        origin_ = dvec3(bounds_.centre());
        nodes_.reserve(triangles_.size());
        build(0, static_cast<std::uint32_t>(triangles_.size()));
    }
}

std::uint32_t SurfaceTree::build(std::uint32_t begin, std::uint32_t end) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Node node;
    node.begin = begin;
    node.end = end;
    Aabb box, middles;
    for (std::uint32_t i = begin; i < end; ++i) {
        for (const vec3& p : triangles_[i]) {
            box.add(p);
        }
        middles.add(middle(triangles_[i]));
    }
    node.centre = dvec3(box.centre()) - origin_;
    for (std::uint32_t i = begin; i < end; ++i) {
        for (const vec3& p : triangles_[i]) {
            node.radius = std::max(node.radius, glm::length(dvec3(p) - origin_ - node.centre));
        }
    }
    if (end - begin > kLeaf) {
        const vec3 size = middles.size();
        const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const std::uint32_t half = begin + (end - begin) / 2;
        std::nth_element(triangles_.begin() + begin, triangles_.begin() + half, triangles_.begin() + end,
                         [&](const auto& a, const auto& b) { return middle(a)[axis] < middle(b)[axis]; });
        const std::uint32_t left = build(begin, half);
        node.right = build(half, end);
        for (const std::uint32_t child : {left, node.right}) {
            node.area += nodes_[child].area;
            node.first += nodes_[child].first;
            node.second += nodes_[child].second;
        }
    } else {
        for (std::uint32_t i = begin; i < end; ++i) {
            const dvec3 a = dvec3(triangles_[i][0]) - origin_, b = dvec3(triangles_[i][1]) - origin_,
                        c = dvec3(triangles_[i][2]) - origin_;
            const double area = 0.5 * glm::length(glm::cross(b - a, c - a));
            const dvec3 sum = a + b + c;
            node.area += area;
            node.first += sum * (area / 3);
            node.second +=
                area / 12 * (glm::dot(a, a) + glm::dot(b, b) + glm::dot(c, c) + glm::dot(sum, sum));
        }
    }
    nodes_[index] = node;
    return index;
}

AreaMoment SurfaceTree::within(const vec3& centre, double radius) const {
    AreaMoment sum;
    if (nodes_.empty() || !(radius > 0)) {
        return sum;
    }
    const dvec3 c = dvec3(centre) - origin_;
    std::array<std::uint32_t, 64> stack{};  // deeper than any balanced tree
    std::size_t waiting = 1;
    while (waiting > 0) {
        const Node& node = nodes_[stack[--waiting]];
        const double distance = glm::length(node.centre - c);
        if (distance - node.radius >= radius) {
            continue;
        }
        if (distance + node.radius <= radius) {
            sum += {node.area, node.second - 2 * glm::dot(c, node.first) + glm::dot(c, c) * node.area};
            continue;
        }
        if (node.right != 0) {
            stack[waiting++] = node.right;
            stack[waiting++] = static_cast<std::uint32_t>(&node - nodes_.data()) + 1;
            continue;
        }
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
            const auto& t = triangles_[i];
            sum += sphere_triangle(
                {dvec3(t[0]) - origin_ - c, dvec3(t[1]) - origin_ - c, dvec3(t[2]) - origin_ - c}, radius);
        }
    }
    return sum;
}

}  // namespace lanthorn::gi
