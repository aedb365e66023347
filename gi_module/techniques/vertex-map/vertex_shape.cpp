#include "gi_module/techniques/vertex-map/vertex_shape.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::gi {

namespace {

// Drawn edges are at most this share of the radius that an estimate's photons are found in.
constexpr float kEdgePerRadius = 1;
// A transform that changes lengths by less than this share is rigid.
constexpr float kRigid = 1e-3f;

// That a mesh is split into, at most, unless it has more triangles itself: some 500 bytes each.
constexpr std::size_t kMostPieces = 1u << 20;

std::size_t pieces_of(std::uint8_t level) {
    return std::size_t{1} << (2 * level);
}
std::size_t pieces_of(const std::vector<std::uint8_t>& levels) {
    std::size_t sum = 0;
    for (const std::uint8_t level : levels) {
        sum += pieces_of(level);
    }
    return sum;
}

bool same_scale(const mat4& a, const mat4& b) {
    const mat3 p(a), q(b);
    if ((glm::determinant(p) < 0) != (glm::determinant(q) < 0)) {
        return false;  // fronts are backs now
    }
    const mat3 change = glm::transpose(p) * p - glm::transpose(q) * q;
    const float size = std::max({glm::dot(p[0], p[0]), glm::dot(p[1], p[1]), glm::dot(p[2], p[2])});
    float most = 0;
    for (glm::length_t i = 0; i < 3; ++i) {
        for (glm::length_t j = 0; j < 3; ++j) {
            most = std::max(most, std::abs(change[i][j]));
        }
    }
    return most <= kRigid * size;
}

std::uint64_t topology_of(const InstanceShape& shape) {
    return shape.deformed() != nullptr && shape.deformed()->refined ? shape.deformed()->refined->serial : 0;
}

}  // namespace

VertexShape::VertexShape(const FrameScene& scene, const Instance& instance, const VertexDetail& detail)
    : key_(surface_key(instance.id, instance.mesh)), lit_as_(key_), detail_(detail) {
    const InstanceShape shape(scene, instance);
    topology_ = topology_of(shape);
    mesh_version_ = scene.mesh_version(instance).any;
    both_sides_ = scene.material(instance).double_sided;
    indices_.assign(shape.indices().begin(), shape.indices().end());
    place(scene, instance);
    mirrored_ = glm::determinant(mat3(instance.transform)) < 0;
    for (std::size_t i = 0; i + 2 < indices_.size(); i += 3) {
        if (mirrored_) {  // it shows its fronts the other way round
            std::swap(indices_[i + 1], indices_[i + 2]);
        }
        const vec3 a = positions_[indices_[i]], b = positions_[indices_[i + 1]],
                   c = positions_[indices_[i + 2]];
        longest_.push_back(std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)}));
        levels_.push_back(level_for_edge(longest_.back(), detail.edge));
    }
    while (pieces_of(levels_) > std::max(kMostPieces, levels_.size())) {
        for (std::uint8_t& level : levels_) {
            level -= level > 0 ? 1 : 0;
        }
    }
    split();
}

bool VertexShape::is_of(const FrameScene& scene, const Instance& instance) const {
    return key_ == surface_key(instance.id, instance.mesh) &&
           mesh_version_ == scene.mesh_version(instance).any &&
           topology_ == topology_of(InstanceShape(scene, instance)) &&
           both_sides_ == scene.material(instance).double_sided;
}

bool VertexShape::follow(const FrameScene& scene, const Instance& instance) {
    if (transform_ == instance.transform && deformed_ == instance.version) {
        return true;
    }
    if (!same_scale(transform_, instance.transform)) {
        return false;
    }
    place(scene, instance);
    set_points();
    surface_.reset();
    ++pose_;
    for (CornerLight& light : light_) {
        light.version = 0;
    }
    return true;
}

void VertexShape::place(const FrameScene& scene, const Instance& instance) {
    const InstanceShape shape(scene, instance);
    transform_ = instance.transform;
    deformed_ = instance.version;
    const mat3 linear(transform_);
    // The transposed cofactors, which turn normals rightly and need no inverse.
    const mat3 turn(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                    glm::cross(linear[0], linear[1]));
    positions_.resize(shape.vertex_count());
    normals_.resize(positions_.size());
    const float side = glm::determinant(linear) < 0 ? -1.0f : 1.0f;
    for (std::size_t i = 0; i < positions_.size(); ++i) {
        positions_[i] = vec3(transform_ * vec4(shape.position(i), 1));
        const vec3 normal =
            side * (turn * (shape.deformed() != nullptr ? (*shape.deformed()->vertices)[i].normal
                                                        : shape.mesh().vertices[i].normal));
        const float length = glm::length(normal);
        normals_[i] = length > 0 ? normal / length : vec3(0);
    }
}

void VertexShape::split() {
    mesh_ = make_vertex_mesh({positions_, normals_, indices_}, levels_, detail_.shared);
    const auto corners = static_cast<std::uint32_t>(mesh_.corners.size());
    triangles_ = mesh_.triangles;
    hanging_ = mesh_.hanging;
    if (both_sides_) {
        for (std::size_t i = 0; i < mesh_.triangles.size(); i += 3) {
            for (const std::size_t k : {0u, 2u, 1u}) {
                triangles_.push_back(mesh_.triangles[i + k] + corners);
            }
        }
        for (const HangingCorner& h : mesh_.hanging) {
            hanging_.push_back({h.corner + corners, h.from + corners, h.to + corners, h.share});
        }
    }
    const std::size_t points = corners * (both_sides_ ? 2u : 1u);
    hangs_.assign(points, -1);
    for (std::size_t i = 0; i < hanging_.size(); ++i) {
        hangs_[hanging_[i].corner] = static_cast<std::int32_t>(i);
    }
    light_.assign(points, {});
    shares_.assign(points, {});
    has_shares_.assign(points, 0);
    set_points();
}

void VertexShape::set_points() {
    const std::size_t corners = mesh_.corners.size();
    points_.resize(light_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const Corner& corner = mesh_.corners[i % corners];
        const vec3 normal = corner.of(std::span<const vec3>(normals_));
        const float length = glm::length(normal);
        points_[i].position = corner.of(std::span<const vec3>(positions_));
        points_[i].normal = (i < corners ? 1.0f : -1.0f) * (length > 0 ? normal / length : vec3(0));
        points_[i].surface = lit_as_;
    }
}

void VertexShape::take_light_of(SurfaceKey surface) {
    if (surface == lit_as_) {
        return;
    }
    lit_as_ = surface;
    for (EstimatePoint& point : points_) {
        point.surface = surface;
    }
    for (CornerLight& light : light_) {
        light.version = 0;
    }
}

bool VertexShape::refine(bool coarser) {
    if (detail_.density <= 0) {
        return false;
    }
    // By triangle of the mesh: the smallest radius among the estimates on it.
    std::vector<float> radii(levels_.size(), std::numeric_limits<float>::infinity());
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        const CornerLight& light = light_[triangles_[i]];
        if (light.version != 0 && light.estimate.photons > 0) {
            float& radius = radii[mesh_.sources[(i / 3) % mesh_.sources.size()]];
            radius = std::min(radius, light.estimate.radius);
        }
    }
    bool changed = false;
    std::size_t pieces = pieces_of(levels_);
    for (std::size_t t = 0; t < levels_.size(); ++t) {
        if (!std::isfinite(radii[t])) {
            continue;
        }
        const int base = level_for_edge(longest_[t], detail_.edge);
        const int wanted = level_for_edge(longest_[t], kEdgePerRadius * radii[t]);
        const int most = std::min(base + detail_.density, static_cast<int>(kMostLevels));
        const int level = std::clamp(wanted, base, most);
        // One level less is worth no change: the next estimate may want it back.
        const std::size_t then = pieces - pieces_of(levels_[t]) + pieces_of(static_cast<std::uint8_t>(level));
        const bool finer = level > levels_[t] && then <= kMostPieces;
        if (finer || (coarser && level + 1 < levels_[t])) {
            pieces = then;
            levels_[t] = static_cast<std::uint8_t>(level);
            changed = true;
        }
    }
    if (changed) {
        split();
    }
    return changed;
}

std::optional<VertexShape::At> VertexShape::at(std::uint32_t primitive, const vec2& barycentric,
                                               bool front) const {
    if (primitive >= levels_.size() || !(front || both_sides_)) {
        return std::nullopt;
    }
    const vec2 b = mirrored_ ? vec2(barycentric.y, barycentric.x) : barycentric;
    const PieceAt piece = piece_at(levels_[primitive], {1 - b.x - b.y, b.x, b.y});
    const std::size_t triangle = mesh_.firsts[primitive] + piece.piece;
    if (front) {
        return At{triangle, piece.weights};
    }
    // Backs go round the other way.
    return At{mesh_.sources.size() + triangle, {piece.weights.x, piece.weights.z, piece.weights.y}};
}

void VertexShape::prepare_shares(const VertexDetail& detail) {
    if (!surface_) {
        surface_ = std::make_unique<SurfaceTriangles>(positions_, indices_, detail.reach);
    }
}

const SurfaceShares& VertexShape::shares_of(std::size_t corner) {
    if (has_shares_[corner] == 0) {
        shares_[corner] = surface_->about(points_[corner].position, points_[corner].normal, both_sides_);
        has_shares_[corner] = 1;
    }
    return shares_[corner];
}

}  // namespace lanthorn::gi
