#version 450 core
// Irradiance of a whole level (LISTED 0: one invocation a pixel) or of the pixels that up-sampling has listed (LISTED 1).
#if LISTED
layout(local_size_x = 64) in;
#else
layout(local_size_x = 8, local_size_y = 8) in;
#endif

#include "splat_gather.glsl"
layout(rgba32f, binding = 0) uniform writeonly image2D irradiance;
#if LISTED
layout(std430, binding = 6) readonly buffer Redo { uint redo_count; uint redo_groups[3]; uint redo[]; };
#endif
uniform int stride;  // full-size pixels a side of this level's pixels

void main() {
#if LISTED
    if (gl_GlobalInvocationID.x >= redo_count) return;
    uint entry = redo[gl_GlobalInvocationID.x];
    ivec2 p = ivec2(int(entry & 0xffffu), int(entry >> 16u));
#else
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(irradiance)))) return;
#endif
    ivec2 pixel = min(p * stride + stride / 2, image_size - 1);
    vec3 x;
    vec3 n;
    float d = surface_at(pixel, x, n);
    vec3 e = gather(x, n, pixel);
    bool bad = any(isnan(e)) || any(isinf(e));
    imageStore(irradiance, p, vec4(d > 0.0 && !bad ? e : vec3(0.0), d));
}
