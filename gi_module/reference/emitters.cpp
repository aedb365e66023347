#include "gi_module/reference/emitters.h"

#include <algorithm>
#include <cmath>

#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

Emitters::Emitters(TraceScene& scene, const MaterialTable& materials, bool blended)
    : scene_(scene), materials_(materials) {
    for (TraceTriangle& triangle : scene.triangles()) {
        triangle.emitter = kNoEmitter;
    }
    std::vector<double> flux;
    double total = 0;
    for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
        const TraceInstance& instance = scene.instances()[i];
        const MaterialConstants& material = materials[instance.material];
        if (!material.emits || (material.blend && !blended)) {
            continue;
        }
        const mat4& transform = scene.frame().instances[i].transform;
        const auto count = static_cast<std::uint32_t>(instance.mesh->indices.size() / 3);
        for (std::uint32_t k = 0; k < count; ++k) {
            vec3 p[3];
            for (std::size_t v = 0; v < 3; ++v) {
                const std::uint32_t index = instance.mesh->indices[3 * std::size_t{k} + v];
                p[v] = vec3(transform * vec4(instance.mesh->vertices[index].position, 1));
            }
            const double area =
                0.5 * glm::length(glm::cross(dvec3(p[1]) - dvec3(p[0]), dvec3(p[2]) - dvec3(p[0])));
            const double sides = material.double_sided ? 2 : 1;
            const double lumen = static_cast<double>(luminance(material.mean_emission)) * area * sides *
                                 static_cast<double>(kPi);
            if (!(lumen > 0) || !std::isfinite(lumen)) {
                continue;
            }
            const std::uint32_t triangle = instance.first_triangle + k;
            scene.triangles()[triangle].emitter = static_cast<std::uint32_t>(triangles_.size());
            const TraceTriangle& traced = scene.triangles()[triangle];
            triangles_.push_back({p[0], p[1] - p[0], p[2] - p[0], traced.normal, material.mean_emission, i, k,
                                  static_cast<float>(1 / area), traced.offset, material.double_sided,
                                  material.emits_evenly});
            flux.push_back(lumen);
            total += lumen;
        }
    }
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        triangles_[i].density *= static_cast<float>(flux[i] / total);
    }
    make_alias_table(flux, total);
}

// Vose 1991, "A linear algorithm for generating random numbers with a given distribution".
void Emitters::make_alias_table(const std::vector<double>& flux, double total) {
    const std::size_t n = flux.size();
    std::vector<double> scaled;
    std::vector<std::uint32_t> small, large;
    for (std::size_t i = 0; i < n; ++i) {
        scaled.push_back(flux[i] / total * static_cast<double>(n));
        (scaled[i] < 1 ? small : large).push_back(static_cast<std::uint32_t>(i));
    }
    slots_.assign(n, {1, 0});
    while (!small.empty() && !large.empty()) {
        const std::uint32_t s = small.back(), l = large.back();
        small.pop_back();
        slots_[s] = {static_cast<float>(scaled[s]), l};
        scaled[l] -= 1 - scaled[s];
        if (scaled[l] < 1) {
            large.pop_back();
            small.push_back(l);
        }
    }
}

const EmitterTriangle& Emitters::draw_triangle(float choice, vec2& u) const {
    const float place = (many() ? choice : u.x) * static_cast<float>(slots_.size());
    const std::size_t index = std::min(static_cast<std::size_t>(place), slots_.size() - 1);
    const float rest = place - static_cast<float>(index);
    const Slot& slot = slots_[index];
    const bool itself = rest < slot.threshold;
    if (!many()) {
        u.x = itself ? rest / slot.threshold : (rest - slot.threshold) / (1 - slot.threshold);
        u.x = std::min(u.x, 0x1.fffffep-1f);
    }
    return triangles_[itself ? index : slot.alias];
}

vec3 Emitters::radiance(const EmitterTriangle& triangle, const vec2& barycentric) const {
    return triangle.uniform
               ? triangle.radiance
               : materials_.emission(scene_.instances()[triangle.instance], triangle.primitive, barycentric);
}

EmitterSample Emitters::draw(float choice, vec2 u) const {
    const EmitterTriangle& t = draw_triangle(choice, u);
    const vec3 b = triangle_point(u);
    EmitterSample sample;
    sample.position = t.corner + t.edge1 * b.y + t.edge2 * b.z;
    sample.normal = t.normal;
    sample.radiance = radiance(t, {b.y, b.z});
    sample.density = t.density;
    sample.offset = t.offset;
    sample.two_sided = t.two_sided;
    return sample;
}

float Emitters::density(const SurfaceHit& hit, float distance, float cosine) const {
    const std::uint32_t emitter = scene_.triangles()[hit.triangle].emitter;
    if (emitter == kNoEmitter) {
        return 0;
    }
    return triangles_[emitter].density * distance * distance / std::max(cosine, 1e-20f);
}

}  // namespace lanthorn::reference
