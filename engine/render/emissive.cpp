#include "lanthorn/render/emissive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lanthorn/core/colour.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::render {

namespace {

vec3 mean_colour(const Image& image) {
    std::array<double, 256> linear;
    for (int i = 0; i < 256; ++i) {
        linear[static_cast<std::size_t>(i)] = linear_from_srgb(i / 255.0);
    }
    dvec3 sum(0);
    const std::size_t pixels = image.rgba.size() / 4;
    for (std::size_t i = 0; i < pixels; ++i) {
        sum += dvec3(linear[image.rgba[4 * i]], linear[image.rgba[4 * i + 1]], linear[image.rgba[4 * i + 2]]);
    }
    return pixels > 0 ? vec3(sum / static_cast<double>(pixels)) : vec3(1);
}

float luminance(const vec3& colour) {
    return glm::dot(colour, vec3(0.2126f, 0.7152f, 0.0722f));
}

// Blended surfaces take no part in the lighting of others.
bool gives_light(const Material& material) {
    return material.emits() && material.alpha_mode != AlphaMode::blend;
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

vec3 EmissiveTriangles::radiance_of(const SceneAssets& assets, std::uint32_t material) {
    radiance_.resize(std::max(radiance_.size(), assets.materials.size()));
    Radiance& kept = radiance_[material];
    const std::uint64_t version = assets.materials.version(material).emission;
    if (kept.emission != version) {
        const Material& m = assets.materials[material];
        kept = {version, m.emissive};
        if (m.emissive_texture.present()) {
            kept.nits *= mean_colour(assets.images[assets.textures[m.emissive_texture.texture].image]);
        }
    }
    return kept.nits;
}

void EmissiveTriangles::build(const FrameScene& scene) {
    const SceneAssets& assets = *scene.assets;
    triangles_.clear();
    at_rest_.clear();
    surfaces_.clear();
    dvec3 total(0);
    for (const Instance& instance : scene.instances) {
        const InstanceShape shape(scene, instance);
        const Mesh& mesh = shape.mesh();
        if (!gives_light(assets.materials[mesh.material])) {
            continue;
        }
        const bool both_sides = assets.materials[mesh.material].double_sided;
        const vec3 radiance = radiance_of(assets, mesh.material);
        const bool refined = shape.deformed() != nullptr && shape.deformed()->refined != nullptr;
        const bool mirrored = glm::determinant(mat3(instance.transform)) < 0;
        Surface surface{instance.id, static_cast<std::uint32_t>(triangles_.size()), 0, vec3(0)};
        dvec3 flux(0);
        for (std::size_t i = 0; i + 2 < shape.indices().size(); i += 3) {
            vec3 p[3];
            Rest rest{};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t vertex = shape.indices()[i + k];
                p[k] = vec3(instance.transform * vec4(shape.position(vertex), 1));
                rest.p[k] = refined ? shape.position(vertex) : mesh.vertices[vertex].position;
            }
            if (mirrored) {
                std::swap(p[1], p[2]);
                std::swap(rest.p[1], rest.p[2]);
            }
            const float area = 0.5f * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
            const vec3 triangle_flux = radiance * (kPi * area * (both_sides ? 2.0f : 1.0f));
            if (!(luminance(triangle_flux) > 0)) {
                continue;
            }
            flux += dvec3(triangle_flux);
            triangles_.push_back({vec4(p[0], 0), vec4(p[1], both_sides ? 1 : 0),
                                  vec4(p[2], luminance(triangle_flux)), vec4(radiance, area)});
            at_rest_.push_back(rest);
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
