#version 450 core
// Indirect irradiance of every pixel, and what its specular lobe reflects of the same light (GLOSSY 1: some lobe is worth it).
layout(local_size_x = 8, local_size_y = 8) in;

#include "radiance_sample.h"
#ifdef SAMPLES_ARE_HIDDEN
#include "hidden_sample.glsl"
#endif
#include "drm_gather.glsl"
#define BAD_VALUES_BINDING 5
#include "gi_module/shared/bad_values.glsl"
#include "engine/render/camera.glsl"
#include "engine/render/octahedral.glsl"
#if GLOSSY
#include "glossy_lobe.glsl"
layout(rgba32f, binding = 1) writeonly uniform image2D specular;
uniform sampler2D mirrored;  // what rays have found for lobes that are narrower
uniform int has_mirrored;
#endif
layout(rgba32f, binding = 0) writeonly uniform image2D irradiance;

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform ivec2 image_size;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, image_size))) return;
    float seen = texelFetch(gbuffer_distance, pixel, 0).r;
    vec2 uv = (vec2(pixel) + 0.5) / vec2(image_size);
    vec3 x = render_position(uv, seen);
    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).xy);
    vec3 e = seen > 0.0 ? gathered_irradiance(x, normal) : vec3(0.0);
#if GLOSSY
    vec4 lobe = seen > 0.0 ? gathered_lobe(pixel, x, -pixel_direction(uv), normal) : vec4(0.0);
    if (is_bad(lobe.rgb)) {
        atomicAdd(bad_value_count, 1u);
        lobe = vec4(0.0);
    }
    if (has_mirrored != 0) lobe += texelFetch(mirrored, pixel, 0);
    imageStore(specular, pixel, lobe);
#endif
    if (is_bad(e)) {
        atomicAdd(bad_value_count, 1u);
        e = vec3(0.0);
    }
    imageStore(irradiance, pixel, vec4(e, 0.0));
}
