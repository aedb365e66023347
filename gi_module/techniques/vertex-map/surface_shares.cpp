#include "gi_module/techniques/vertex-map/surface_shares.h"

#include <algorithm>
#include <cmath>

#include "gi_module/shared/photons/circle_triangle.h"
#include "gi_module/shared/photons/copies.h"

namespace lanthorn::gi {

namespace {

constexpr int kMostCells = 64;  // an axis

// Two unit vectors square to unit `n` and each other, right-handed with it.
void plane_axes(const vec3& n, vec3& u, vec3& v) {
    u = glm::normalize(glm::cross(n, std::abs(n.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0)));
    v = glm::cross(n, u);
}

}  // namespace

SurfaceTriangles::SurfaceTriangles(std::span<const vec3> positions, std::span<const std::uint32_t> indices,
                                   float reach)
    : reach_(reach) {
    Aabb box;
    const std::vector<std::uint32_t> first = first_of_copies(indices, vertex_places(positions));
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        if (first[i / 3] != i / 3) {
            continue;
        }
        const vec3 a = positions[indices[i]], b = positions[indices[i + 1]], c = positions[indices[i + 2]];
        const vec3 square = glm::cross(b - a, c - a);
        const float doubled = glm::length(square);
        if (doubled > 0) {
            const vec3 middle = (a + b + c) * (1.0f / 3);
            const float radius =
                std::max({glm::distance(a, middle), glm::distance(b, middle), glm::distance(c, middle)});
            triangles_.push_back({a, b, c, square / doubled, 0.5f * doubled, middle, radius});
            box.add(a);
            box.add(b);
            box.add(c);
        }
    }
    if (triangles_.size() > kMany) {
        tree_ = AreaTree(triangles_);
        return;
    }
    lower_ = triangles_.empty() ? vec3(0) : box.lower;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const float size = box.size()[axis];
        cells_[axis] = std::clamp(static_cast<int>(size / std::max(reach, 1e-30f)), 1, kMostCells);
        per_metre_[axis] = size > 0 ? static_cast<float>(cells_[axis]) / size : 0.0f;
    }
    // Twice over the triangles: how many a cell has, then which.
    first_.assign(static_cast<std::size_t>(cells_.x * cells_.y * cells_.z) + 1, 0);
    const auto each_cell = [&](const auto& visit) {
        for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
            const SurfaceTriangle& triangle = triangles_[t];
            const vec3 low = glm::min(glm::min(triangle.a, triangle.b), triangle.c) - reach_;
            const vec3 high = glm::max(glm::max(triangle.a, triangle.b), triangle.c) + reach_;
            const ivec3 from = cell_of(low), to = cell_of(high);
            for (int z = from.z; z <= to.z; ++z) {
                for (int y = from.y; y <= to.y; ++y) {
                    for (int x = from.x; x <= to.x; ++x) {
                        visit(index_of({x, y, z}), t);
                    }
                }
            }
        }
    };
    each_cell([&](std::size_t cell, std::uint32_t) { ++first_[cell + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) {
        first_[i] += first_[i - 1];
    }
    list_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    each_cell([&](std::size_t cell, std::uint32_t t) { list_[next[cell]++] = t; });
}

ivec3 SurfaceTriangles::cell_of(const vec3& p) const {
    return glm::clamp(ivec3(glm::floor(glm::clamp((p - lower_) * per_metre_, -1.0f, 1e4f))), ivec3(0),
                      cells_ - 1);
}

std::size_t SurfaceTriangles::index_of(const ivec3& cell) const {
    return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(cells_.y) +
            static_cast<std::size_t>(cell.y)) *
               static_cast<std::size_t>(cells_.x) +
           static_cast<std::size_t>(cell.x);
}

void SurfaceTriangles::add(const SurfaceTriangle& t, const vec3& point, const vec3& normal, bool both_sides,
                           AreaTree::Areas& areas) const {
    const float agrees = glm::dot(t.normal, normal);
    if (!((both_sides ? std::abs(agrees) : agrees) > kSameSurface)) {
        return;
    }
    const vec3 a = t.a - point, b = t.b - point, c = t.c - point;
    const float height = glm::dot(a, t.normal);
    const float furthest = std::sqrt(std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)}));
    if (std::abs(height) >= reach_) {
        return;
    }
    const float nearest = glm::length(t.middle - point) - t.radius;
    vec3 u, v;
    plane_axes(t.normal, u, v);
    const auto flat = [&](const vec3& p) { return glm::dvec2(glm::dot(p, u), glm::dot(p, v)); };
    const std::array<glm::dvec2, 3> corners{flat(a), flat(b), flat(c)};
    for (std::size_t k = 0; k < SurfaceShares::kSteps; ++k) {
        const float radius = reach_ * SurfaceShares::step(k);
        const float across2 = radius * radius - height * height;
        if (furthest <= radius) {
            areas[k] += t.area;
        } else if (across2 > 0 && radius > nearest) {
            const double across = std::sqrt(static_cast<double>(across2));
            areas[k] += static_cast<float>(circle_triangle(corners, across).area);
        }
    }
}

SurfaceShares SurfaceTriangles::about(const vec3& point, const vec3& normal, bool both_sides) const {
    AreaTree::Areas areas{};
    if (!tree_.empty()) {
        tree_.add(point, normal, both_sides, reach_, areas,
                  [&](std::uint32_t t) { add(triangles_[t], point, normal, both_sides, areas); });
    } else {
        const std::size_t cell = index_of(cell_of(point));
        for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
            add(triangles_[list_[i]], point, normal, both_sides, areas);
        }
    }
    SurfaceShares result;
    for (std::size_t k = 0; k < SurfaceShares::kSteps; ++k) {
        const float radius = reach_ * SurfaceShares::step(k);
        result.shares[k] = areas[k] / (kPi * radius * radius);
    }
    return result;
}

}  // namespace lanthorn::gi
