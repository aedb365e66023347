#include "gi_module/techniques/vertex-map/vertex_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/scene/alpha_coverage.h"
#include "gi_module/shared/photons/copies.h"

namespace lanthorn::gi {

namespace {

constexpr float kOtherDiagonal = 1.25f;
constexpr std::size_t kRun = 32;  // estimates that a thread makes at once

VertexDetail detail_of(const VertexMapSettings& settings, float diagonal) {
    return {settings.edge * diagonal, settings.distance * diagonal, settings.density, settings.corners};
}

// The scene's diagonal, metres; but no more than its things' own make together, which far ones between which
// there is nothing do not enlarge. O(instances).
float size_of(const FrameScene& scene) {
    double squares = 0;
    for (const Instance& instance : scene.instances) {
        const double own = instance.bounds.empty() ? 0 : static_cast<double>(instance.bounds.diagonal());
        squares += own * own;
    }
    const float together = static_cast<float>(std::sqrt(squares));
    return together > 0 ? std::min(together, scene.diagonal()) : scene.diagonal();
}

// A corner of a shape that is to be estimated.
struct Task {
    VertexShape* shape;
    std::uint32_t corner;
};

}  // namespace

void VertexScene::clear() {
    *this = {};
}

bool VertexScene::follow(const FrameScene& scene, const VertexMapSettings& settings) {
    const float diagonal = size_of(scene);
    if (!(diagonal < kOtherDiagonal * diagonal_ && diagonal * kOtherDiagonal > diagonal_)) {
        diagonal_ = diagonal;
    }
    const VertexDetail detail = detail_of(settings, diagonal_);
    bool changed = !(detail == detail_);
    if (changed) {
        shapes_.clear();
        detail_ = detail;
    }
    std::vector<std::unique_ptr<VertexShape>> now;
    auto before = shapes_.begin();
    const std::vector<std::uint32_t> copies = first_of_copies(scene);
    shape_of_.assign(scene.instances.size(), -1);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Material& material = scene.material(instance);
        if (material.alpha_mode == AlphaMode::blend && material.base_colour.a < kSolidAlpha) {
            continue;  // no camera sees it solid
        }
        // Both are in the order of instances.
        const SurfaceKey key = surface_key(instance.id, instance.mesh);
        for (; before != shapes_.end() && (*before)->key() < key; ++before) {
            changed = true;
        }
        std::unique_ptr<VertexShape> shape;
        if (before != shapes_.end() && (*before)->is_of(scene, instance)) {
            const std::uint64_t pose = (*before)->pose();
            shape = (*before)->follow(scene, instance) ? std::move(*before) : nullptr;
            changed = changed || !shape || shape->pose() != pose;
            ++before;
        }
        if (!shape) {
            shape = std::make_unique<VertexShape>(scene, instance, detail_);
            changed = true;
        }
        const Instance& lit = scene.instances[copies[i]];
        shape->take_light_of(surface_key(lit.id, lit.mesh));
        shape_of_[i] = static_cast<std::int32_t>(now.size());
        now.push_back(std::move(shape));
    }
    changed = changed || before != shapes_.end();
    shapes_ = std::move(now);
    count();
    return changed;
}

bool VertexScene::refine(bool coarser) {
    bool changed = false;
    for (const auto& shape : shapes_) {
        changed = shape->refine(coarser) || changed;
    }
    count();
    return changed;
}

void VertexScene::count() {
    triangles_ = corners_ = 0;
    firsts_.clear();
    for (const auto& shape : shapes_) {
        firsts_.push_back({triangles_, static_cast<std::uint32_t>(corners_)});
        triangles_ += shape->triangles().size() / 3;
        corners_ += shape->points().size();
    }
}

void VertexScene::list_positions(std::vector<vec3>& positions) const {
    positions.clear();
    for (const auto& shape : shapes_) {
        for (const EstimatePoint& point : shape->points()) {
            positions.push_back(point.position);
        }
    }
}

void VertexScene::list_triangles(std::vector<std::uint32_t>& triangles) const {
    triangles.clear();
    std::uint32_t first = 0;
    for (const auto& shape : shapes_) {
        for (const std::uint32_t corner : shape->triangles()) {
            triangles.push_back(first + corner);
        }
        first += static_cast<std::uint32_t>(shape->points().size());
    }
}

void VertexScene::list_light(std::vector<vec4>& light, vec3 LightEstimate::*part) const {
    light.clear();
    for (const auto& shape : shapes_) {
        const std::size_t first = light.size();
        for (const CornerLight& corner : shape->light()) {
            light.emplace_back(corner.estimate.*part, 1);
        }
        for (const HangingCorner& h : shape->hanging()) {
            light[first + h.corner] = glm::mix(light[first + h.from], light[first + h.to], h.share);
        }
    }
}

EstimateSettings VertexScene::estimate_settings(const VertexMapSettings& settings) const {
    return {static_cast<std::size_t>(settings.nearest), detail_.reach, settings.kernel, settings.any_surface};
}

std::optional<VertexScene::At> VertexScene::at(std::uint32_t instance, std::uint32_t primitive,
                                               const vec2& barycentric, bool front) const {
    const std::int32_t index = instance < shape_of_.size() ? shape_of_[instance] : -1;
    if (index < 0) {
        return std::nullopt;
    }
    const VertexShape& shape = *shapes_[static_cast<std::size_t>(index)];
    const auto found = shape.at(primitive, barycentric, front);
    if (!found) {
        return std::nullopt;
    }
    const First& first = firsts_[static_cast<std::size_t>(index)];
    At result{first.triangle + found->triangle, {}, found->weights};
    for (std::size_t k = 0; k < 3; ++k) {
        result.corners[k] = first.corner + shape.triangles()[3 * found->triangle + k];
    }
    return result;
}

LightEstimate VertexScene::estimate_at(std::uint32_t instance, const vec3& position, const vec3& normal,
                                       const PhotonTree& tree, const PhotonStore& store,
                                       const VertexMapSettings& settings) {
    const std::int32_t index = instance < shape_of_.size() ? shape_of_[instance] : -1;
    if (index < 0) {
        return {};
    }
    VertexShape& shape = *shapes_[static_cast<std::size_t>(index)];
    SurfaceShares shares;
    if (settings.surface_area) {
        shape.prepare_shares(detail_);
        shares = shape.shares_at(position, normal);
    }
    return RadianceEstimate().at({position, normal, shape.lit_as()}, shares, tree, store,
                                 estimate_settings(settings), 0);
}

std::size_t VertexScene::estimate(std::span<const std::uint32_t> wanted, std::uint64_t version,
                                  const PhotonTree& tree, const PhotonStore& store,
                                  const VertexMapSettings& settings, reference::TileWorkers& workers) {
    const EstimateSettings estimate = estimate_settings(settings);
    std::vector<Task> tasks;
    std::size_t triangle = 0;
    for (const auto& shape : shapes_) {
        const std::size_t before = tasks.size();
        const std::vector<std::uint32_t>& corners = shape->triangles();
        const auto want = [&](std::uint32_t corner) {
            CornerLight& light = shape->light()[corner];
            if (light.version != version) {
                light.version = version;
                tasks.push_back({shape.get(), corner});
            }
        };
        for (std::size_t i = 0; i < corners.size(); i += 3, ++triangle) {
            if (!wanted.empty() && wanted[triangle] == 0) {
                continue;
            }
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t hangs = shape->hangs()[corners[i + k]];
                if (hangs < 0) {
                    want(corners[i + k]);
                } else {
                    want(shape->hanging()[static_cast<std::size_t>(hangs)].from);
                    want(shape->hanging()[static_cast<std::size_t>(hangs)].to);
                }
            }
        }
        if (settings.surface_area && tasks.size() > before) {
            shape->prepare_shares(detail_);
        }
    }
    workers.run((tasks.size() + kRun - 1) / kRun, [&](std::size_t run) {
        RadianceEstimate estimates;
        static const SurfaceShares kWhole;
        const std::size_t end = std::min((run + 1) * kRun, tasks.size());
        for (std::size_t i = run * kRun; i < end; ++i) {
            VertexShape& shape = *tasks[i].shape;
            const std::uint32_t corner = tasks[i].corner;
            CornerLight& light = shape.light()[corner];
            // A little more than the last radius: the nearest photons are mostly within it again.
            constexpr float kMore = 1.06f;
            light.estimate =
                estimates.at(shape.points()[corner], settings.surface_area ? shape.shares_of(corner) : kWhole,
                             tree, store, estimate, kMore * light.estimate.radius);
        }
    });
    return tasks.size();
}

std::vector<std::uint32_t> VertexScene::facing(const CameraView& camera) const {
    const vec3 forward = -vec3(camera.view[0][2], camera.view[1][2], camera.view[2][2]);
    std::vector<std::uint32_t> result;
    result.reserve(triangles_);
    for (const auto& shape : shapes_) {
        const std::vector<std::uint32_t>& corners = shape->triangles();
        for (std::size_t i = 0; i < corners.size(); i += 3) {
            const vec3 a = shape->points()[corners[i]].position;
            const vec3 normal = glm::cross(shape->points()[corners[i + 1]].position - a,
                                           shape->points()[corners[i + 2]].position - a);
            const vec3 towards = camera.camera.orthographic ? -forward : camera.position - a;
            result.push_back(glm::dot(normal, towards) > 0 ? 1u : 0u);
        }
    }
    return result;
}

}  // namespace lanthorn::gi
