// How much of a surface lies within a sphere: what a kernel's support covers of it (Lavignotte and Paulin
// 2003, sec. 4.1).
//
// The paper walks from triangle to triangle across edges that the sphere cuts. That finds the part of the
// surface that is connected within the sphere, while photons count wherever on the surface they lie within
// it; here all of the surface within the sphere is found, by a tree of its triangles, at a cost that does not
// grow with how many of them lie inside as a whole.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gi_module/shared/photons/circle_triangle.h"

namespace lanthorn::gi {

class SurfaceTree {
  public:
    SurfaceTree() = default;
    // O(n log n).
    explicit SurfaceTree(std::vector<std::array<vec3, 3>> triangles);

    double area() const { return nodes_.empty() ? 0 : nodes_[0].area; }
    const Aabb& bounds() const { return bounds_; }
    // Area and moment about `centre` of what lies within `radius` of it. O(log n + triangles cut).
    AreaMoment within(const vec3& centre, double radius) const;

  private:
    struct Node {
        dvec3 centre{0};  // of a sphere about its triangles, relative to origin_
        double radius = 0;
        double area = 0;
        dvec3 first{0};                    // integral of the position
        double second = 0;                 // of its square
        std::uint32_t begin = 0, end = 0;  // triangles
        std::uint32_t right = 0;           // the left child comes next; 0: a leaf
    };
    std::uint32_t build(std::uint32_t begin, std::uint32_t end);

    dvec3 origin_{0};
    Aabb bounds_;
    std::vector<std::array<vec3, 3>> triangles_;
    std::vector<Node> nodes_;
};

}  // namespace lanthorn::gi
