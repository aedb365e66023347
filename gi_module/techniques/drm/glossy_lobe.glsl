// What a pixel's specular lobe reflects of the samples' light: each is a small lamp to it, and as a lobe narrower than the sample
// would show it as a point, the lobe is as wide as both (Karis 2013, "Real Shading in Unreal Engine 4", sec. on area lights).
#ifndef LANTHORN_DRM_GLOSSY_LOBE_GLSL
#define LANTHORN_DRM_GLOSSY_LOBE_GLSL

#include "engine/render/brdf_table.glsl"
#include "engine/render/gbuffer_flags.glsl"
#include "engine/render/ggx.glsl"
#include "engine/render/traced_lobes.glsl"

uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_material;
uniform float most_roughness;  // of surfaces whose lobes mirrors.h traces

const float kEvenRoughness = 0.85;  // from here on a lobe sees about what the whole hemisphere sends

// Radiance towards unit `v`, nits, and the share of the lobe that it stands for.
vec4 gathered_lobe(ivec2 pixel, vec3 x, vec3 v, vec3 normal) {
    vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
    vec4 material = texelFetch(gbuffer_material, pixel, 0);
    float share = traced_share(material.r, kEvenRoughness) * (1.0 - traced_share(material.r, most_roughness));
    if (share <= 0.0 || flags_say_unlit(material.a)) return vec4(0.0);
    float nv = dot(normal, v);
    vec2 even = brdf_share(nv, material.r);
    vec3 fresnel = reflectance(albedo.rgb, albedo.a, material.g, nv, even).specular / max(even.x + even.y, 1e-3);
    float alpha = max(material.r * material.r, 2e-3);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < sample_count; ++i) {
        RadianceSample s = radiance_samples[i];
        vec3 d = s.position - x;
        float r2 = max(dot(d, d), least_distance);
        vec3 l = d * inversesqrt(r2);
        float cosine = dot(normal, l);
        if (cosine <= 0.0) continue;
        // Half of the angle that the sample is seen under adds to the lobe's, whose tangent is about alpha.
        float wide = clamp(alpha + 0.25 * sqrt(s.area / (s.area + r2)), 0.0, 1.0);
        float lobe = ggx_lobe(normal, v, l, wide) / max(cosine, 1e-4);
        sum += s.sent * (seen_share_of_sample(s, x, normal) * lobe);
    }
    return vec4(sum * fresnel * (share * material.b), share);
}

#endif
