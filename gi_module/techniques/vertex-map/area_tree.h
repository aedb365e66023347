// A surface of many triangles by parts: how much of it lies within spheres about a point.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gi_module/techniques/vertex-map/radiance_estimate.h"

namespace lanthorn::gi {

struct SurfaceTriangle {
    vec3 a{0}, b{0}, c{0};
    vec3 normal{0};  // unit
    float area = 0;  // square metres
    vec3 middle{0};
    float radius = 0;  // metres about the middle
};

class AreaTree {
  public:
    AreaTree() = default;
    // O(triangles log triangles), 60 bytes a triangle.
    explicit AreaTree(std::span<const SurfaceTriangle> triangles);
    bool empty() const { return nodes_.empty(); }

    using Areas = std::array<float, SurfaceShares::kSteps>;
    // Square metres within the radius of each step of `reach`, as SurfaceTriangles::about() has them. Parts
    // that are small beside their distance count as one (Barnes and Hut 1986); `exact` adds a triangle.
    // O(log triangles).
    template <class Exact>
    void add(const vec3& point, const vec3& normal, bool both_sides, float reach, Areas& areas,
             const Exact& exact) const {
        std::array<std::uint32_t, 64> open;
        std::size_t count = 0;
        for (open[count++] = 0; count > 0;) {
            const std::uint32_t at = open[--count];
            const Node& node = nodes_[at];
            const float distance = glm::distance(node.middle, point);
            const Agreement agrees = agreement(node, normal, both_sides);
            if (distance - node.radius >= reach || agrees == Agreement::none) {
                continue;
            }
            if (agrees == Agreement::all && node.radius < kSmall * distance) {
                add_whole(node, distance, reach, areas);
            } else if (node.count > 0) {
                for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                    exact(order_[i]);
                }
            } else {
                open[count++] = at + 1;
                open[count++] = node.first;
            }
        }
    }

  private:
    static constexpr float kSmall = 0.15f;  // radius of a part that counts as one, beside its distance
    struct Node {
        vec3 middle{0};
        float radius = 0;  // metres about the middle
        vec3 normal{0};    // unit
        float cone = 0;    // radians, that normals of its triangles are off it at most
        float area = 0;
        std::uint32_t first =
            0;  // of its triangles in order_; without: its second child, the first follows it
        std::uint32_t count = 0;
    };
    enum class Agreement { none, some, all };

    std::uint32_t build(std::span<const SurfaceTriangle> triangles, std::uint32_t first, std::uint32_t end);
    static Agreement agreement(const Node& node, const vec3& normal, bool both_sides);
    static void add_whole(const Node& node, float distance, float reach, Areas& areas);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace lanthorn::gi
