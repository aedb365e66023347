#version 450 core
// Irradiance at points: the mean of what the lit texels reflect that their rays have met, and the mean square of its luminance.
// IN_PICTURE 1: rays of a point are a list in no order; their sum is one of whole numbers, the same in any order. 0: they are
// those of its key, in theirs.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "gather_surface.glsl"

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 1) writeonly buffer Irradiance { vec4 irradiance[]; };  // lux; a: lux^2, -1: nothing is known
layout(std430, binding = 2) writeonly buffer Known { float known[]; };           // rays behind it

uniform samplerBuffer radiosity;  // by place, lux; a < 0: not lit
#if IN_PICTURE
uniform usamplerBuffer served;    // what rays have met, in the order of points
uniform usamplerBuffer offsets;
uniform usamplerBuffer counts;
#else
uniform usamplerBuffer remembered;
uniform usamplerBuffer keys;
#endif

// What comes along a ray, and in a whether it is known.
vec4 incoming(uint id) {
    vec4 b = texelFetch(radiosity, id < kNoRay ? int(id) : 0);
    bool lit = id < kNoRay && b.a >= 0.0;
    return vec4(lit ? b.rgb : vec3(0.0), lit || id == kMiss ? 1.0 : 0.0);
}

void main() {
    uint i = work_item();
    if (i >= point_count) return;
#if IN_PICTURE
    int first = int(texelFetch(offsets, int(i)).r) * rays;
    int end = first + int(texelFetch(counts, int(i)).r) * rays;
    float most = 0.0;
    for (int k = first; k < end; ++k) {
        vec3 b = incoming(texelFetch(served, k).r).rgb;
        most = max(most, max(b.r, max(b.g, b.b)));
    }
    // 2^31 / rays steps to the largest one.
    float steps = exp2(30.0 - ceil(log2(float(max(end - first, 1)))));
    float scale = most > 0.0 ? steps / most : 0.0;
    uvec3 sums = uvec3(0u);
    uint square_sum = 0u;
    uint rays_known = 0u;
    for (int k = first; k < end; ++k) {
        vec4 b = incoming(texelFetch(served, k).r);
        float y = luminance(b.rgb) / max(most, 1e-30);
        sums += uvec3(b.rgb * scale);
        square_sum += uint(y * y * steps);
        rays_known += uint(b.a);
    }
    float n = float(rays_known);
    vec3 sum = scale > 0.0 ? vec3(sums) / scale : vec3(0.0);
    float squares = float(square_sum) / steps * most * most;
#else
    int key = int(texelFetch(keys, int(i)).r);
    vec3 sum = vec3(0.0);
    float squares = 0.0;
    float n = 0.0;
    for (int k = 0; k < int(kRemembered) * rays; ++k) {
        vec4 b = incoming(met(texelFetch(remembered, k * capacity + key).r));
        float y = luminance(b.rgb);
        sum += b.rgb;
        squares += y * y;
        n += b.a;
    }
#endif
    vec3 mean = sum / max(n, 1.0);
    irradiance[i] = vec4(mean, n > 0.0 ? squares / n : -1.0);
    known[i] = n;
}
