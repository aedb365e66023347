#include "gi_module/shared/rays/triangle_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gi_module/shared/cube_direction.h"

namespace lanthorn::gi {

namespace {

using reference::Blended;
using reference::TraceScene;

constexpr int kRows = 8;  // of texels that a thread takes at once
// Rasterisers move corners to places of a 256th of a texel: an edge as near as this to a texel's middle may
// pass on its other side.
constexpr float kNearEdge = 1.0f / 128;  // texels
constexpr float kOutline = 1.1f;         // times as far as beside it
constexpr float kSheet = 1e-3f;          // of the distance: environment_map.frag has it, too
constexpr float kBeyond = 1e-6f;         // of the distance, that rays go on behind what they look through
constexpr int kMostLookedThrough = 64;

// The inverse of cube_direction(): right, up, forward.
vec3 of_face(int face, const vec3& q) {
    switch (face) {
        case 0:
            return {q.z, q.y, q.x};
        case 1:
            return {-q.z, q.y, -q.x};
        case 2:
            return {q.x, q.z, q.y};
        case 3:
            return {q.x, q.z, -q.y};
        case 4:
            return {-q.x, q.y, q.z};
        default:
            return {q.x, q.y, -q.z};
    }
}

class FaceRays {
  public:
    FaceRays(const FollowedScene& scene, const CubeFace& face, std::span<const std::uint8_t> stands)
        : scene_(scene), face_(face), stands_(stands), half_(0.5f * static_cast<float>(face.resolution)) {}

    void look(int first_row, int end_row, std::vector<SeenTriangle>& seen) {
        const int side = face_.resolution;
        queries_.clear();
        for (int y = first_row; y < end_row; ++y) {
            for (int x = 0; x < side; ++x) {
                queries_.push_back(query(middle(x, y)));
            }
        }
        scene_.scene().intersect_all(queries_);
        find_outlines(end_row - first_row);
        std::size_t k = 0;
        for (int y = first_row; y < end_row; ++y) {
            for (int x = 0; x < side; ++x, ++k) {
                const vec2 p = middle(x, y);
                const std::size_t before = seen.size();
                add(queries_[k], p, seen);
                if (outline_[k] != 0 || (seen.size() > before && edge_is_near(seen[before], p))) {
                    for (const vec2& off : {vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1)}) {
                        const vec2 beside = p + off * (kNearEdge / half_);
                        std::array<RTCRayHit, 1> again{query(beside)};
                        scene_.scene().intersect_all(again);
                        add(again[0], beside, seen);
                    }
                }
            }
        }
    }

  private:
    // Where texels beside each other meet things at different depths, slivers that no ray meets may lie.
    void find_outlines(int rows) {
        const int side = face_.resolution;
        outline_.assign(queries_.size(), 0);
        const auto compare = [&](int a, int b) {
            const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
            const float s = queries_[i].ray.tfar, t = queries_[j].ray.tfar;
            if (s != t && !(std::max(s, t) < kOutline * std::min(s, t))) {
                outline_[i] = outline_[j] = 1;
            }
        };
        for (int y = 0; y < rows; ++y) {
            for (int x = 0; x < side; ++x) {
                if (x + 1 < side) {
                    compare(y * side + x, y * side + x + 1);
                }
                if (y + 1 < rows) {
                    compare(y * side + x, (y + 1) * side + x);
                }
            }
        }
    }

    // On the face, which reaches from -1 to 1.
    vec2 middle(int x, int y) const { return (vec2(x, y) + 0.5f) / half_ - 1.0f; }

    RTCRayHit query(const vec2& p) const {
        return TraceScene::query(face_.centre, cube_direction(face_.face, p), 0,
                                 std::numeric_limits<float>::infinity(), Blended::met);
    }

    // What the ray met, or meets behind what is looked through. What is cut out of masked and blended
    // surfaces a rasteriser may see otherwise: they are seen, and what lies behind them.
    void add(RTCRayHit& ray, const vec2& p, std::vector<SeenTriangle>& seen) const {
        for (int k = 0; ray.hit.geomID != RTC_INVALID_GEOMETRY_ID && k < kMostLookedThrough; ++k) {
            const std::uint32_t instance = scene_.scene().instance_of(ray);
            const reference::MaterialConstants& material =
                scene_.materials()[scene_.scene().instances()[instance].material];
            if (stands_[instance] != 0) {
                add_met(ray, p, seen);
                if (!material.mask && !material.blend) {
                    return;
                }
            }
            ray.ray.tnear = ray.ray.tfar * (1 + kBeyond);
            ray.ray.tfar = std::numeric_limits<float>::infinity();
            ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            scene_.scene().intersect_all(std::span(&ray, 1));
        }
    }

    void add_met(const RTCRayHit& ray, const vec2& p, std::vector<SeenTriangle>& seen) const {
        seen.push_back({scene_.scene().instance_of(ray), ray.hit.primID});
        reference::SurfaceHit hit;
        scene_.scene().found(ray, hit);
        if (!hit.front) {
            // Of a wall of two sheets in one place the front counts.
            const float t = ray.ray.tfar;
            reference::SurfaceHit front;
            if (scene_.scene().intersect(face_.centre, cube_direction(face_.face, p), t * (1 - kSheet),
                                         t * (1 + kSheet), Blended::met, front, reference::Sides::seen) &&
                stands_[front.instance] != 0) {
                seen.push_back({front.instance, front.primitive});
            }
        }
    }

    bool edge_is_near(const SeenTriangle& triangle, const vec2& p) const {
        const std::array<vec3, 3> corners = scene_.scene().corners(triangle.instance, triangle.primitive);
        vec2 at[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const vec3 q = of_face(face_.face, corners[k] - face_.centre);
            if (!(q.z > 0)) {
                return true;  // it reaches behind the centre
            }
            at[k] = (vec2(q) / q.z - p) * half_;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const vec2 along = at[(k + 1) % 3] - at[k];
            const float length = glm::length(along);
            // Far off the edge's ends it counts as near, too: that costs no more than rays.
            const float distance = std::abs(along.x * at[k].y - along.y * at[k].x);
            if (!(distance > kNearEdge * length)) {
                return true;
            }
        }
        return false;
    }

    const FollowedScene& scene_;
    CubeFace face_;
    std::span<const std::uint8_t> stands_;
    float half_;
    std::vector<RTCRayHit> queries_;
    std::vector<std::uint8_t> outline_;  // by query
};

}  // namespace

std::vector<std::vector<SeenTriangle>> see_triangles(const FollowedScene& scene,
                                                     std::span<const CubeFace> faces,
                                                     std::span<const std::uint8_t> stands,
                                                     reference::TileWorkers& workers) {
    struct Part {
        std::size_t face;
        int first_row, end_row;
    };
    std::vector<Part> parts;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (int row = 0; row < faces[f].resolution; row += kRows) {
            parts.push_back({f, row, std::min(row + kRows, faces[f].resolution)});
        }
    }
    std::vector<std::vector<SeenTriangle>> of_part(parts.size());
    workers.run(parts.size(), [&](std::size_t i) {
        FaceRays rays(scene, faces[parts[i].face], stands);
        rays.look(parts[i].first_row, parts[i].end_row, of_part[i]);
        std::ranges::sort(of_part[i]);
        of_part[i].erase(std::unique(of_part[i].begin(), of_part[i].end()), of_part[i].end());
    });
    std::vector<std::vector<SeenTriangle>> result(faces.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::vector<SeenTriangle>& all = result[parts[i].face];
        all.insert(all.end(), of_part[i].begin(), of_part[i].end());
    }
    workers.run(result.size(), [&](std::size_t f) {
        std::ranges::sort(result[f]);
        result[f].erase(std::unique(result[f].begin(), result[f].end()), result[f].end());
    });
    return result;
}

}  // namespace lanthorn::gi
