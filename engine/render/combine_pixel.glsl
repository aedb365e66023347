// Adds up what a pixel's surface reflects and emits: radiance in nits; alpha 0 background, 1 lit, 2 unlit.
// WITH_SKY, WITH_IRRADIANCE, WITH_SPECULAR: what there is besides direct light.
#include "composite_state.glsl"
#include "camera.glsl"
#include "sky.glsl"
#include "brdf_table.glsl"
#include "gbuffer_flags.glsl"
#include "octahedral.glsl"

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_material;
uniform sampler2D gbuffer_emissive;
uniform sampler2D direct_radiance;
uniform sampler2D indirect_irradiance;
uniform sampler2D indirect_specular;
uniform float emissive_scale;

vec4 pixel_value(ivec2 pixel, vec2 centre) {
    vec2 uv = (vec2(pixel) + 0.5) / vec2(textureSize(gbuffer_distance, 0));
    if (texelFetch(gbuffer_distance, pixel, 0).r <= 0.0) {
#ifdef WITH_SKY
        return vec4(sky_radiance(pixel_direction(uv)), 0.0);
#else
        return vec4(0.0);
#endif
    }
    vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
    vec4 material = texelFetch(gbuffer_material, pixel, 0);
    if (flags_say_unlit(material.a)) {
        return vec4(albedo.rgb, 2.0);
    }
    vec3 sum = texelFetch(direct_radiance, pixel, 0).rgb;
    sum += texelFetch(gbuffer_emissive, pixel, 0).rgb * emissive_scale;
    vec4 specular = vec4(0.0);
#ifdef WITH_SPECULAR
    specular = texelFetch(indirect_specular, pixel, 0);
    sum += specular.rgb;
#endif
#ifdef WITH_IRRADIANCE
    // A wide lobe sees about what the whole hemisphere sends: what of it the technique has not traced is lit by irradiance.
    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).xy);
    float nv = dot(normal, -pixel_direction(uv));
    Reflectance reflects = reflectance(albedo.rgb, albedo.a, material.g, nv, brdf_share(nv, material.r));
    vec3 irradiance = texelFetch(indirect_irradiance, pixel, 0).rgb;
    sum += irradiance * (reflects.diffuse + reflects.specular * (1.0 - specular.a)) * (material.b * 0.31830988618);
#endif
    if (is_bad(sum)) {
        atomicAdd(state.nan_count, 1u);
        sum = vec3(0.0);
    }
    return vec4(sum, 1.0);
}

#include "pixel_pass.glsl"
