#include "gi_module/reference/material_table.h"

#include <algorithm>
#include <cmath>

#include "engine/scene/emissive_pieces.h"
#include "engine/scene/texture_lookup.h"
#include "gi_module/reference/bsdf.h"
#include "gi_module/reference/sampling.h"
#include "gi_module/reference/trace_scene.h"

namespace lanthorn::reference {

namespace {

// The three vertices of a triangle and how much of each a point has.
struct Corners {
    const Vertex* v[3] = {};
    float weight[3] = {};

    Corners() = default;
    Corners(const Mesh& mesh, std::uint32_t primitive, const vec2& barycentric)
        : weight{1 - barycentric.x - barycentric.y, barycentric.x, barycentric.y} {
        for (std::size_t i = 0; i < 3; ++i) {
            v[i] = &mesh.vertices[mesh.indices[3 * std::size_t{primitive} + i]];
        }
    }
    template <class T>
    T mix(T Vertex::*field) const {
        return v[0]->*field * weight[0] + v[1]->*field * weight[1] + v[2]->*field * weight[2];
    }
};

class Textures {
  public:
    Textures(const SceneAssets& assets, const Corners& corners) : assets_(assets), corners_(corners) {}

    vec4 operator()(const TextureRef& reference, bool srgb) const {
        const vec3 uv(corners_.mix(reference.uv_set == 1 ? &Vertex::uv1 : &Vertex::uv0), 1);
        return sample_texture(
            assets_, assets_.textures[reference.texture],
            {glm::dot(reference.uv_transform[0], uv), glm::dot(reference.uv_transform[1], uv)}, srgb);
    }

  private:
    const SceneAssets& assets_;
    const Corners& corners_;
};

vec4 base_colour(const Material& m, const Corners& corners, const Textures& textures) {
    vec4 base = m.base_colour * corners.mix(&Vertex::colour);
    if (m.base_colour_texture.present()) {
        base *= textures(m.base_colour_texture, true);
    }
    return base;
}

float dielectric_f0(const Material& m, const Textures& textures) {
    const float r = (m.ior - 1) / (m.ior + 1);
    float strength = m.specular;
    vec3 colour = m.specular_colour;
    if (m.specular_texture.present()) {
        strength *= textures(m.specular_texture, false).a;
    }
    if (m.specular_colour_texture.present()) {
        colour *= vec3(textures(m.specular_colour_texture, true));
    }
    return std::min(r * r * luminance(colour), 1.0f) * strength;
}

SurfaceMaterial surface_at(const Material& m, const vec4& base, const Textures& textures) {
    SurfaceMaterial s;
    s.base_colour = vec3(base);
    s.alpha = m.alpha_mode == AlphaMode::blend ? glm::clamp(base.a, 0.0f, 1.0f) : 1.0f;
    s.emissive = m.emissive;
    if (m.emits() && m.emissive_texture.present()) {
        s.emissive *= vec3(textures(m.emissive_texture, true));
    }
    s.metallic = m.metallic;
    s.roughness = m.roughness;
    if (m.metallic_roughness_texture.present()) {
        const vec4 t = textures(m.metallic_roughness_texture, false);
        s.roughness *= t.g;
        s.metallic *= t.b;
    }
    if (m.occlusion_texture.present()) {
        s.occlusion = 1 + m.occlusion_strength * (textures(m.occlusion_texture, false).r - 1);
    }
    s.transmission = m.transmission;
    if (m.transmission_texture.present()) {
        s.transmission *= textures(m.transmission_texture, false).r;
    }
    s.f0 = dielectric_f0(m, textures);
    return s;
}

// As albedo_to_keep() and kept_albedo() of engine/render.
vec3 reflectance_of(const MaterialConstants& c, const vec3& base, float metallic, float transmission,
                    float roughness) {
    if (c.unlit) {
        return vec3(0);
    }
    const float tinted =
        base_reflectance(metallic, transmission, roughness, c.reflects.transmittance, c.reflects.evenly);
    return glm::min(base * tinted + c.reflects.boundary, vec3(1));
}

MaterialConstants describe(const Material& m, const SceneAssets& assets) {
    MaterialConstants c;
    c.plain = !m.base_colour_texture.present() && !m.metallic_roughness_texture.present() &&
              !m.transmission_texture.present();
    c.mask = m.alpha_mode == AlphaMode::mask;
    c.blend = m.alpha_mode == AlphaMode::blend;
    c.double_sided = m.double_sided;
    c.unlit = m.unlit;
    c.emits = gives_light(m);
    c.emits_evenly = c.emits && !m.emissive_texture.present() && m.alpha_mode == AlphaMode::opaque;
    // One that shines is a lamp: drawn as such, it lets nothing through.
    c.volume = m.bounds_volume() && m.transmission > 0 && !m.unlit && !m.emits();
    c.ior = m.ior;
    c.absorption = m.absorption();
    c.transmits =
        m.transmission > 0 && (m.metallic < 1 || m.metallic_roughness_texture.present()) && !m.unlit;
    c.sees_through = !c.volume && (c.blend || (m.transmission > 0 && is_smooth(m.roughness)));
    c.reflects = MaterialReflectance::of(m);
    c.reflectance = reflectance_of(c, vec3(m.base_colour), m.metallic, m.transmission, m.roughness);
    c.emitted = emitted(m);
    c.untextured = c.plain && !m.emissive_texture.present() && !m.occlusion_texture.present() &&
                   !m.specular_texture.present() && !m.specular_colour_texture.present();
    if (c.untextured) {
        const Corners nowhere;
        c.surface = surface_at(m, m.base_colour, Textures(assets, nowhere));
    }
    return c;
}

}  // namespace

SurfaceMaterial SurfaceMaterial::opaque_part() const {
    SurfaceMaterial rest = *this;
    const float share = metallic + (1 - metallic) * (1 - transmission);
    rest.alpha = 1;
    rest.transmission = 0;
    rest.metallic = share > 0 ? metallic / share : 1.0f;
    return rest;
}

MaterialTable::MaterialTable(const SceneAssets& assets) : assets_(assets) {
    constants_.resize(assets.materials.size());
    for (std::size_t slot = 0; slot < constants_.size(); ++slot) {
        if (assets.materials.has(slot)) {
            constants_[slot] = describe(assets.materials[slot], assets);
        }
    }
}

vec3 MaterialTable::reflectance(const TraceInstance& instance, std::uint32_t primitive,
                                const vec2& barycentric) const {
    const MaterialConstants& constants = constants_[instance.material];
    if (constants.plain && !instance.coloured) {
        return constants.reflectance;
    }
    if (constants.unlit) {
        return vec3(0);
    }
    const Material& m = assets_.materials[instance.material];
    const Corners corners(*instance.mesh, primitive, barycentric);
    const Textures textures(assets_, corners);
    float metallic = m.metallic;
    float roughness = m.roughness;
    float transmission = m.transmission;
    if (m.metallic_roughness_texture.present()) {
        const vec4 t = textures(m.metallic_roughness_texture, false);
        roughness *= t.g;
        metallic *= t.b;
    }
    if (m.transmission_texture.present()) {
        transmission *= textures(m.transmission_texture, false).r;
    }
    return reflectance_of(constants, vec3(base_colour(m, corners, textures)), metallic, transmission,
                          roughness);
}

SurfaceMaterial MaterialTable::evaluate(const TraceInstance& instance, std::uint32_t primitive,
                                        const vec2& barycentric) const {
    const MaterialConstants& constants = constants_[instance.material];
    if (constants.untextured && !instance.coloured) {
        return constants.surface;
    }
    const Material& m = assets_.materials[instance.material];
    const Corners corners(*instance.mesh, primitive, barycentric);
    const Textures textures(assets_, corners);
    return surface_at(m, base_colour(m, corners, textures), textures);
}

vec3 MaterialTable::emission(const TraceInstance& instance, std::uint32_t primitive,
                             const vec2& barycentric) const {
    const MaterialConstants& constants = constants_[instance.material];
    if (constants.emits_evenly) {
        return constants.emitted;
    }
    if (cut_out(instance, primitive, barycentric)) {
        return vec3(0);
    }
    const SurfaceMaterial s = evaluate(instance, primitive, barycentric);
    return s.emissive * s.alpha;
}

bool MaterialTable::cut_out(const TraceInstance& instance, std::uint32_t primitive,
                            const vec2& barycentric) const {
    const Material& m = assets_.materials[instance.material];
    if (m.alpha_mode != AlphaMode::mask) {
        return false;
    }
    const Corners corners(*instance.mesh, primitive, barycentric);
    return base_colour(m, corners, Textures(assets_, corners)).a < m.alpha_cutoff;
}

float MaterialTable::alpha(const TraceInstance& instance, std::uint32_t primitive,
                           const vec2& barycentric) const {
    const Material& m = assets_.materials[instance.material];
    const Corners corners(*instance.mesh, primitive, barycentric);
    return base_colour(m, corners, Textures(assets_, corners)).a;
}

vec3 MaterialTable::shading_normal(const TraceInstance& instance, const SurfaceHit& hit) const {
    const Material& m = assets_.materials[instance.material];
    // Interpolated after each vertex's normal is made unit in render space, as the vertex shader does.
    const std::uint32_t* v = &instance.mesh->indices[3 * std::size_t{hit.primitive}];
    vec3 n = instance.normals[v[0]] * (1 - hit.barycentric.x - hit.barycentric.y) +
             instance.normals[v[1]] * hit.barycentric.x + instance.normals[v[2]] * hit.barycentric.y;
    const float length = glm::length(n);
    if (!(length > 1e-6f)) {
        return hit.normal;
    }
    n /= length;
    if (m.normal_texture.present()) {
        const Corners corners(*instance.mesh, hit.primitive, hit.barycentric);
        const vec4 tangent = corners.mix(&Vertex::tangent);
        vec3 t = instance.to_render * vec3(tangent);
        t -= n * glm::dot(n, t);
        const float t_length = glm::length(t);
        if (t_length > 0) {
            t /= t_length;
            const vec3 b = glm::cross(n, t) * (tangent.w * instance.mirror);
            vec3 p = vec3(Textures(assets_, corners)(m.normal_texture, false)) * 2.0f - 1.0f;
            p.x *= m.normal_scale;
            p.y *= m.normal_scale;
            n = glm::normalize(t * p.x + b * p.y + n * std::max(p.z, 1e-3f));
        }
    }
    return hit.front ? n : -n;
}

}  // namespace lanthorn::reference
