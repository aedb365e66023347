#include "gi_module/reference/emitters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

std::shared_ptr<const EmissivePieces> pieces_of(const TraceScene& scene, std::uint32_t instance,
                                                KeptEmissivePieces& kept) {
    const SceneAssets& assets = *scene.frame().assets;
    const TraceInstance& of = scene.instances()[instance];
    const std::uint32_t slot = scene.frame().instances[instance].mesh;
    if (of.mesh->indices == assets.meshes[slot].indices) {
        return kept.of(assets, slot);
    }
    const Material& material = assets.materials[of.material];
    return gives_light(material) && glows_in_pieces(material)
               ? std::make_shared<const EmissivePieces>(emissive_pieces(assets, *of.mesh, material))
               : nullptr;
}

Emitters::Emitters(TraceScene& scene, const MaterialTable& materials, KeptEmissivePieces* kept)
    : scene_(scene), materials_(materials), pieces_(scene.instances().size()) {
    for (TraceTriangle& triangle : scene.triangles()) {
        triangle.emitter = kNoEmitter;
    }
    std::vector<double> flux;
    KeptEmissivePieces own;
    for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
        const TraceInstance& instance = scene.instances()[i];
        const MaterialConstants& material = materials[instance.material];
        if (!material.emits) {
            continue;
        }
        pieces_[i] = pieces_of(scene, i, kept != nullptr ? *kept : own);
        const auto count = static_cast<std::uint32_t>(instance.mesh->indices.size() / 3);
        for (std::uint32_t k = 0; k < count; ++k) {
            const auto first = static_cast<std::uint32_t>(triangles_.size());
            add(scene, i, k, material, flux);
            if (triangles_.size() > first) {
                scene.triangles()[instance.first_triangle + k].emitter = first;
            }
        }
    }
    const double total = std::accumulate(flux.begin(), flux.end(), 0.0);
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        triangles_[i].density *= static_cast<float>(flux[i] / total);
    }
    make_alias_table(flux, total);
}

// The triangle or all its pieces, so that they can be found by number; nothing where none gives light.
void Emitters::add(const TraceScene& scene, std::uint32_t instance, std::uint32_t primitive,
                   const MaterialConstants& material, std::vector<double>& flux) {
    const TraceInstance& of = scene.instances()[instance];
    const mat4& transform = scene.frame().instances[instance].transform;
    const TraceTriangle& traced = scene.triangles()[of.first_triangle + primitive];
    std::array<vec3, 3> p;
    for (std::size_t v = 0; v < 3; ++v) {
        const std::uint32_t index = of.mesh->indices[3 * std::size_t{primitive} + v];
        p[v] = vec3(transform * vec4(of.mesh->vertices[index].position, 1));
    }
    static constexpr std::array<EmissivePiece, 1> kUncut{
        EmissivePiece{{vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}, vec3(1)}};
    const EmissivePieces* cut = pieces_[instance].get();
    const std::span<const EmissivePiece> pieces = cut != nullptr ? cut->of(primitive) : std::span(kUncut);
    const vec3 nits = emitted(scene.frame().assets->materials[of.material]);
    const double sides = material.double_sided ? 2 : 1;
    const std::size_t first = triangles_.size();
    double whole = 0;
    for (std::size_t n = 0; n < pieces.size(); ++n) {
        const std::array<vec3, 3> c = cut != nullptr ? pieces[n].within(p) : p;
        const double area =
            0.5 * glm::length(glm::cross(dvec3(c[1]) - dvec3(c[0]), dvec3(c[2]) - dvec3(c[0])));
        const vec3 radiance = nits * pieces[n].share;
        const double lumen =
            static_cast<double>(luminance(radiance)) * area * sides * static_cast<double>(kPi);
        const bool gives = lumen > 0 && std::isfinite(lumen);
        triangles_.push_back({c[0], c[1] - c[0], c[2] - c[0], traced.normal, radiance, instance, primitive,
                              gives ? static_cast<float>(1 / area) : 0.0f, traced.offset,
                              material.double_sided, material.emits_evenly, static_cast<std::uint32_t>(n)});
        flux.push_back(gives ? lumen : 0);
        whole += flux.back();
    }
    if (!(whole > 0)) {
        triangles_.resize(first);
        flux.resize(first);
    }
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
    if (triangle.uniform) {
        return triangle.radiance;
    }
    vec2 at = barycentric;
    if (const EmissivePieces* cut = pieces_[triangle.instance].get()) {
        const auto& corners = cut->of(triangle.primitive)[triangle.piece].corners;
        const vec3 whole = corners[0] * (1 - barycentric.x - barycentric.y) + corners[1] * barycentric.x +
                           corners[2] * barycentric.y;
        at = {whole.y, whole.z};
    }
    return materials_.emission(scene_.instances()[triangle.instance], triangle.primitive, at);
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
    std::size_t piece = 0;
    if (const EmissivePieces* cut = pieces_[hit.instance].get()) {
        const vec2 b = hit.barycentric;
        piece = cut->piece_at(hit.primitive, {1 - b.x - b.y, b.x, b.y});
    }
    return triangles_[emitter + piece].density * distance * distance / std::max(cosine, 1e-20f);
}

}  // namespace lanthorn::reference
