#include "lanthorn/render/emissive.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "engine/scene/kept_emissive_pieces.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::render {

namespace {

using Corners = std::array<vec3, 3>;

Corners wound(const Corners& p, bool mirrored) {
    return mirrored ? Corners{p[0], p[2], p[1]} : p;
}

}  // namespace

void EmissiveTriangles::update(const FrameScene& scene) {
    const SceneAssets& assets = *scene.assets;
    const bool other_assets = assets.serial != serial_;
    const bool skipped = scene.frame != last_frame_ && scene.frame != last_frame_ + 1;
    last_frame_ = scene.frame;
    serial_ = assets.serial;
    if (!other_assets && !skipped && !scene.changes.geometry && buffer_) {
        return;
    }
    std::vector<Source> sources;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.mesh(instance);
        if (gives_light(assets.materials[mesh.material])) {
            const AssetVersion<Material>& version = assets.materials.version(mesh.material);
            sources.push_back({instance.id, instance.mesh, instance.version,
                               assets.meshes.version(instance.mesh).any, version.emission, version.surface,
                               instance.transform});
        }
    }
    if (sources == sources_ && buffer_) {
        return;
    }
    sources_ = std::move(sources);
    build(scene);
    ++version_;
}

void EmissiveTriangles::build(const FrameScene& scene) {
    const SceneAssets& assets = *scene.assets;
    triangles_.clear();
    at_rest_.clear();
    surfaces_.clear();
    if (!pieces_) {
        pieces_ = std::make_shared<KeptEmissivePieces>();
    }
    dvec3 total(0);
    for (const Instance& instance : scene.instances) {
        const InstanceShape shape(scene, instance);
        const Mesh& mesh = shape.mesh();
        if (!gives_light(assets.materials[mesh.material])) {
            continue;
        }
        const bool both_sides = assets.materials[mesh.material].double_sided;
        const vec3 nits = emitted(assets.materials[mesh.material]);
        const bool refined = shape.deformed() != nullptr && shape.deformed()->refined != nullptr;
        const bool mirrored = glm::determinant(mat3(instance.transform)) < 0;
        // Subdivision makes triangles of its own, which have the mean of what the mesh's have.
        const std::shared_ptr<const EmissivePieces> pieces = pieces_->of(assets, instance.mesh);
        const vec3 mean = pieces != nullptr && refined ? mean_share(mesh, mat4(1), *pieces) : vec3(1);
        Surface surface{instance.id, static_cast<std::uint32_t>(triangles_.size()), 0, vec3(0)};
        dvec3 flux(0);
        const auto add = [&](const Corners& shown, const Corners& rest, const vec3& radiance) {
            const float area = 0.5f * glm::length(glm::cross(shown[1] - shown[0], shown[2] - shown[0]));
            const vec3 triangle_flux = radiance * (kPi * area * (both_sides ? 2.0f : 1.0f));
            if (!(luminance(triangle_flux) > 0)) {
                return;
            }
            flux += dvec3(triangle_flux);
            triangles_.push_back({vec4(shown[0], 0), vec4(shown[1], both_sides ? 1 : 0),
                                  vec4(shown[2], luminance(triangle_flux)), vec4(radiance, area)});
            at_rest_.push_back({{rest[0], rest[1], rest[2]}});
        };
        for (std::size_t i = 0; i + 2 < shape.indices().size(); i += 3) {
            Corners p, rest;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t vertex = shape.indices()[i + k];
                p[k] = vec3(instance.transform * vec4(shape.position(vertex), 1));
                rest[k] = refined ? shape.position(vertex) : mesh.vertices[vertex].position;
            }
            if (pieces == nullptr || refined) {
                add(wound(p, mirrored), wound(rest, mirrored), nits * mean);
                continue;
            }
            for (const EmissivePiece& piece : pieces->of(i / 3)) {
                add(wound(piece.within(p), mirrored), wound(piece.within(rest), mirrored),
                    nits * piece.share);
            }
        }
        surface.count = static_cast<std::uint32_t>(triangles_.size()) - surface.first;
        surface.flux = vec3(flux);
        if (surface.count > 0) {
            surfaces_.push_back(surface);
        }
        total += flux;
    }
    flux_ = vec3(total);
    double whole = 0;
    for (const EmissiveTriangleData& t : triangles_) {
        whole += static_cast<double>(t.p2.w);
    }
    double sum = 0;
    for (EmissiveTriangleData& t : triangles_) {
        sum += static_cast<double>(t.p2.w);
        t.p0.w = static_cast<float>(sum / whole);
    }
    if (!triangles_.empty()) {
        triangles_.back().p0.w = 1;
    }
    buffer_.hold(std::span<const EmissiveTriangleData>(triangles_));
}

}  // namespace lanthorn::render
