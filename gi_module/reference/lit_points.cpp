// Places on surfaces that LightSplitter is asked about.
#include <algorithm>
#include <array>
#include <cmath>

#include "gi_module/reference/light_split_state.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

namespace {

using Polygon = std::vector<dvec3>;

// What of it lies where sign * p[axis] <= 0.5 (Sutherland and Hodgman 1974).
Polygon clipped(const Polygon& polygon, int axis, double sign) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec3& a = polygon[i];
        const dvec3& b = polygon[(i + 1) % polygon.size()];
        const double da = sign * a[axis] - 0.5, db = sign * b[axis] - 0.5;
        if (da <= 0) {
            result.push_back(a);
        }
        if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
            result.push_back(a + (b - a) * (da / (da - db)));
        }
    }
    return result;
}

struct Piece {
    std::array<dvec3, 3> corners;  // render space
    std::uint32_t instance, primitive;
    double until;  // area of this one and those before it
};

}  // namespace

std::vector<LitPoint> LightSplitter::points_within(const mat4& to_box, int count) const {
    const State& s = *state_;
    const dmat4 to(to_box), from = glm::inverse(to);
    std::vector<Piece> pieces;
    double area = 0;
    for (std::uint32_t i = 0; i < s.scene.instances().size(); ++i) {
        const TraceInstance& instance = s.scene.instances()[i];
        const MaterialConstants& material = s.materials[instance.material];
        if (material.unlit || material.blend) {
            continue;
        }
        const auto triangles = static_cast<std::uint32_t>(instance.mesh->indices.size() / 3);
        for (std::uint32_t k = 0; k < triangles; ++k) {
            Polygon polygon;
            for (const vec3& corner : s.scene.corners(i, k)) {
                polygon.push_back(dvec3(to * dvec4(dvec3(corner), 1)));
            }
            for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
                polygon = clipped(clipped(polygon, axis, 1), axis, -1);
            }
            for (std::size_t v = 2; v < polygon.size(); ++v) {
                Piece piece{{dvec3(from * dvec4(polygon[0], 1)), dvec3(from * dvec4(polygon[v - 1], 1)),
                             dvec3(from * dvec4(polygon[v], 1))},
                            i,
                            k,
                            0};
                area += 0.5 * glm::length(glm::cross(piece.corners[1] - piece.corners[0],
                                                     piece.corners[2] - piece.corners[0]));
                piece.until = area;
                pieces.push_back(piece);
            }
        }
    }
    std::vector<LitPoint> points;
    if (!(area > 0)) {
        return points;
    }
    for (int n = 0; n < count; ++n) {
        // Systematically by area, and within a piece by the (0,2)-sequence.
        const double wanted = (n + 0.5) / count * area;
        const auto piece = std::ranges::lower_bound(pieces, wanted, {}, &Piece::until);
        if (piece == pieces.end()) {
            continue;
        }
        const vec3 b =
            triangle_point(RandomNumbers(s.settings.seed, 0, static_cast<std::uint32_t>(n)).pair(0));
        const TraceTriangle& triangle =
            s.scene.triangles()[s.scene.instances()[piece->instance].first_triangle + piece->primitive];
        const dvec3 at = piece->corners[0] * static_cast<double>(b.x) +
                         piece->corners[1] * static_cast<double>(b.y) +
                         piece->corners[2] * static_cast<double>(b.z);
        points.push_back({vec3(at), triangle.normal, triangle.offset, s.entity(piece->instance)});
    }
    return points;
}

std::vector<LitPoint> LightSplitter::points_on_disc(const vec3& position, const vec3& normal, float radius,
                                                    int count) const {
    std::vector<LitPoint> points;
    const Basis basis(normal);
    for (int n = 0; n < count; ++n) {
        const vec2 u = RandomNumbers(state_->settings.seed, 1, static_cast<std::uint32_t>(n)).pair(0);
        const vec2 p = on_circle(u.y) * std::sqrt(u.x) * radius;
        points.push_back(
            {position + basis.to_world(vec3(p, 0)), normal, 1e-5f * state_->frame.diagonal(), 0});
    }
    return points;
}

}  // namespace lanthorn::reference
