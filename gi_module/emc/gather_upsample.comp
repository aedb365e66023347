#version 450 core
// From the grid of points to pixels: between the four points around, as gather_fits.comp has found. Pixels that share their surface
// with none of them, or with such alone as know nothing, are listed for gather_lone.comp.
layout(local_size_x = 8, local_size_y = 8) in;

#include "point_lists.glsl"
#include "splat_surface.glsl"
#include "entry_list.glsl"

layout(rgba32f, binding = 0) uniform writeonly image2D picture;

uniform usampler2D fits;
uniform samplerBuffer irradiance;  // lux; a < 0: nothing is known
uniform ivec2 grid;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, image_size))) return;
    vec4 weights = unpackUnorm4x8(texelFetch(fits, pixel, 0).r);
    ivec2 base = ivec2(floor((vec2(pixel) - float(stride / 2)) / float(stride)));
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 q = clamp(base + ivec2(k & 1, k >> 1), ivec2(0), grid - 1);
        vec4 e = texelFetch(irradiance, q.y * grid.x + q.x);
        sum += vec4(e.rgb, 1.0) * (e.a >= 0.0 ? weights[k] : 0.0);
    }
    imageStore(picture, pixel, vec4(sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0), 0.0));
    bool lone = sum.a <= 0.0 && texelFetch(gbuffer_distance, pixel, 0).r > 0.0;
    if (lone) list_entry(uint(pixel.y * image_size.x + pixel.x));
}
