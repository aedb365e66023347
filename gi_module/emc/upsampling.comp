#version 450 core
// One step of multi-level up-sampling (Yao et al. 2010, sec. 6, fig. 9): each pixel of this level takes what the coarse pixels
// around it on the same surface say; where none fits, or they disagree, it is listed to be computed anew.
layout(local_size_x = 8, local_size_y = 8) in;

#include "engine/render/camera.glsl"
#include "engine/render/octahedral.glsl"

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform sampler2D coarse;
layout(rgba32f, binding = 0) uniform writeonly image2D irradiance;
layout(std430, binding = 6) buffer Redo { uint redo_count; uint redo_groups[3]; uint redo[]; };
uniform ivec2 image_size;
uniform int stride;       // of this level; the coarse one's is twice that
uniform float contrast;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(irradiance)))) return;
    ivec2 pixel = min(p * stride + stride / 2, image_size - 1);
    float d = texelFetch(gbuffer_distance, pixel, 0).r;
    if (!(d > 0.0)) {
        imageStore(irradiance, p, vec4(0.0));
        return;
    }
    vec3 x = relative_position((vec2(pixel) + 0.5) / vec2(image_size), d);
    vec3 n = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).zw);
    ivec2 coarse_size = textureSize(coarse, 0);
    int coarse_stride = 2 * stride;
    vec2 at = (vec2(pixel) - float(coarse_stride / 2)) / float(coarse_stride);
    ivec2 base = ivec2(floor(at));
    vec2 f = at - vec2(base);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    float lowest = 1e30;
    float highest = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 offset = ivec2(k & 1, k >> 1);
        ivec2 q = base + offset;
        bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, coarse_size));
        q = clamp(q, ivec2(0), coarse_size - 1);
        vec4 e = texelFetch(coarse, q, 0);  // irradiance, and the distance it was computed at
        vec2 centre = (vec2(min(q * coarse_stride + stride, image_size - 1)) + 0.5) / vec2(image_size);
        vec3 delta = relative_position(centre, e.a) - x;
        // The plane test tells corners apart as well: off the corner, the other wall is off this one's plane.
        float off = dot(n, delta);
        bool same = inside && e.a > 0.0 && off * off < 0.01 * dot(delta, delta) + 1e-10 * d * d;
        vec2 w2 = mix(1.0 - f, f, vec2(offset));
        float w = same ? w2.x * w2.y + 1e-4 : 0.0;
        float y = dot(e.rgb, vec3(0.2126, 0.7152, 0.0722));
        sum += w * e.rgb;
        total += w;
        lowest = same ? min(lowest, y) : lowest;
        highest = same ? max(highest, y) : highest;
    }
    bool redone = total < 0.02 || highest - lowest > contrast * highest;
    if (redone) {
        uint place = atomicAdd(redo_count, 1u);
        redo[place] = uint(p.x) | (uint(p.y) << 16u);
        if ((place & 63u) == 0u) atomicAdd(redo_groups[0], 1u);
    }
    imageStore(irradiance, p, vec4(total > 0.0 ? sum / total : vec3(0.0), d));
}
