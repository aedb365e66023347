// A surface's material at a fragment, textures included. For fragment shaders behind scene_vertex.glsl.
#ifndef LANTHORN_MATERIAL_GLSL
#define LANTHORN_MATERIAL_GLSL
#include "engine/scene/alpha_coverage.h"
#include "engine/scene/include/lanthorn/scene/diffuse_reflectance.h"
#include "engine/render/include/lanthorn/render/scene_structs.h"
#define SCENE_VARYING in
#include "scene_varyings.glsl"

layout(std430, binding = 1) readonly buffer Materials {
    MaterialData materials[];
};

layout(binding = 0) uniform sampler2D material_base_colour;
layout(binding = 1) uniform sampler2D material_metallic_roughness;
layout(binding = 2) uniform sampler2D material_normal;
layout(binding = 3) uniform sampler2D material_occlusion;
layout(binding = 4) uniform sampler2D material_emissive;
layout(binding = 5) uniform sampler2D material_specular;
layout(binding = 6) uniform sampler2D material_specular_colour;
layout(binding = 7) uniform sampler2D material_transmission;

struct SurfaceMaterial {
    vec3 base_colour;  // linear
    float alpha;
    vec3 emissive;  // nits
    float metallic;
    float roughness;  // perceptual
    float f0;         // dielectric reflectance at normal incidence
    float occlusion;
    float transmission;
    bool unlit;
};

// Whether the material has texture `index` (MaterialData::flags).
bool material_has(uint index) {
#ifdef TEXTURES  // SceneProgram: known when compiled
    return (TEXTURES & (1u << index)) != 0u;
#else
    return (scene.flags & (1u << index)) != 0u;
#endif
}

// Texture `index` at this fragment, its coordinates chosen and transformed as the material says. Call outside of divergent
// control flow. The level of detail comes from the interpolated coordinates: what a buffer says is not known in those
// invocations of a 2x2 quad that lie outside the triangle, where implicit derivatives would need it.
vec4 material_texture(sampler2D image, uint index) {
    bool second = (materials[scene.material].uv_sets & (1u << index)) != 0u;
    vec4 dx = dFdx(scene.uv);
    vec4 dy = dFdy(scene.uv);
    vec2 uv = second ? scene.uv.zw : scene.uv.xy;
    vec3 u = materials[scene.material].uv_transform[2u * index].xyz;
    vec3 v = materials[scene.material].uv_transform[2u * index + 1u].xyz;
    mat2 linear = mat2(u.x, v.x, u.y, v.y);
    return textureGrad(image, linear * uv + vec2(u.z, v.z), linear * (second ? dx.zw : dx.xy), linear * (second ? dy.zw : dy.xy));
}

// Base colour and alpha: factor times texture times vertex colour.
vec4 material_base() {
    vec4 base = scene.colour;
    if (material_has(0u)) base *= material_texture(material_base_colour, 0u);
    return base;
}

// Whether a masked material leaves this fragment out, or a blended one does not cover it.
bool material_cut_out(float alpha) {
    if ((scene.flags & kMaterialBlend) != 0u) return alpha <= alpha_threshold(scene.position);
    return (scene.flags & kMaterialMask) != 0u && alpha < materials[scene.material].emissive.w;
}

// The same for maps that photons fly through: open in the same cells of `cell` metres in all of them.
bool material_open(float alpha, float cell) {
    if ((scene.flags & kMaterialBlend) != 0u) return alpha <= coarse_alpha_threshold(scene.position, cell);
    return material_cut_out(alpha);
}

// The same for a camera: what is blended it shows solid where it is next to opaque, and over the picture elsewhere.
bool material_not_solid(float alpha) {
    return (scene.flags & kMaterialBlend) != 0u ? alpha < kSolidAlpha : material_cut_out(alpha);
}

// Only what albedo_to_keep() and material_cut_out() need; the rest is 0. The cheaper one, for maps.
SurfaceMaterial evaluate_diffuse() {
    SurfaceMaterial m;
    vec4 base = material_base();
    m.base_colour = base.rgb;
    m.alpha = base.a;
    m.emissive = vec3(0.0);
    m.metallic = scene.lobes.x;
    m.roughness = scene.lobes.y;
    m.transmission = scene.lobes.z;
    m.f0 = 0.0;
    m.occlusion = 0.0;
    m.unlit = (scene.flags & kMaterialUnlit) != 0u;
    if ((scene.flags & 0x82u) != 0u) {
        if (material_has(1u)) {
            vec4 t = material_texture(material_metallic_roughness, 1u);
            m.roughness *= t.g;
            m.metallic *= t.b;
        }
        if (material_has(7u)) m.transmission *= material_texture(material_transmission, 7u).r;
    }
    return m;
}

// Nits.
vec3 material_emission() {
    if ((scene.flags & kMaterialEmits) == 0u) return vec3(0.0);
    vec3 nits = materials[scene.material].emissive.rgb;
    return material_has(4u) ? nits * material_texture(material_emissive, 4u).rgb : nits;
}

// Everything but the normal.
SurfaceMaterial evaluate_material() {
    SurfaceMaterial m;
    vec4 base = material_base();
    m.base_colour = base.rgb;
    m.alpha = base.a;
    m.metallic = scene.lobes.x;
    m.roughness = scene.lobes.y;
    m.transmission = scene.lobes.z;
    m.f0 = scene.lobes.w;
    m.occlusion = 1.0;
    m.emissive = material_emission();
    m.unlit = (scene.flags & kMaterialUnlit) != 0u;
    if ((scene.flags & 0x8au) != 0u) {
        if (material_has(1u)) {
            vec4 t = material_texture(material_metallic_roughness, 1u);
            m.roughness *= t.g;
            m.metallic *= t.b;
        }
        if (material_has(3u)) {
            float strength = materials[scene.material].occlusion_strength;
            m.occlusion = 1.0 + strength * (material_texture(material_occlusion, 3u).r - 1.0);
        }
        if (material_has(7u)) m.transmission *= material_texture(material_transmission, 7u).r;
    }
    if ((scene.flags & kMaterialSpecular) != 0u) {
        vec4 specular = materials[scene.material].specular_colour;
        if (material_has(5u)) specular.a *= material_texture(material_specular, 5u).a;
        if (material_has(6u)) specular.rgb *= material_texture(material_specular_colour, 6u).rgb;
        m.f0 = min(m.f0 * dot(specular.rgb, vec3(0.2126, 0.7152, 0.0722)), 1.0) * specular.a;
    }
    return m;
}

// What of even light is reflected, as maps keep it, behind vertex shaders with KEEPS_ALBEDO; kept_albedo() reads it.
vec4 albedo_to_keep(SurfaceMaterial m) {
    float share = scene.kept.x;
    if (material_has(1u) || material_has(7u)) {  // what was fetched a vertex knows nothing of these
        vec4 reflects = materials[scene.material].reflects;
        share = base_reflectance(m.metallic, m.transmission, m.roughness, reflects.y, reflects.z);
    }
    vec3 albedo = m.unlit ? vec3(0.0) : m.base_colour * share;
    float others = m.unlit ? 0.0 : scene.kept.y;
    return scene.kept.z > 0.0 ? vec4(albedo, scene.kept.z) : vec4(min(albedo + others, vec3(1.0)), 0.0);
}

// The direction of the triangle's own normal, of any length, on the side that `towards` (from the surface to the viewer)
// points to; `edge_on` where the triangle is seen so. Call outside of divergent control flow.
vec3 geometric_direction(vec3 towards, vec3 edge_on) {
    vec3 dx = dFdx(scene.position);
    vec3 dy = dFdy(scene.position);
    // Scaled first: a scene of millimetres must not underflow.
    vec3 n = cross(dx / max(max(abs(dx.x), max(abs(dx.y), abs(dx.z))), 1e-30),
                   dy / max(max(abs(dy.x), max(abs(dy.y), abs(dy.z))), 1e-30));
    n = dot(n, n) > 1e-20 ? n : edge_on;
    return dot(n, towards) < 0.0 ? -n : n;
}

// The same, unit.
vec3 geometric_normal(vec3 towards) { return normalize(geometric_direction(towards, scene.normal)); }

// The shading normal with normal mapping, unit, turned to the side that is seen.
vec3 shading_normal(bool front_facing) {
    vec3 n = normalize(scene.normal);
    if (material_has(2u)) {
        vec3 t = scene.tangent.xyz - n * dot(n, scene.tangent.xyz);
        float length2 = dot(t, t);
        if (length2 > 0.0) {
            t *= inversesqrt(length2);
            vec3 b = cross(n, t) * scene.tangent.w;
            vec3 m = material_texture(material_normal, 2u).xyz * 2.0 - 1.0;
            m.xy *= materials[scene.material].normal_scale;
            n = normalize(t * m.x + b * m.y + n * max(m.z, 1e-3));
        }
    }
    return front_facing ? n : -n;
}

#endif
