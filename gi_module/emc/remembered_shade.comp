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
uniform usamplerBuffer remembered;
#if IN_PICTURE
uniform usamplerBuffer served;  // starts, in the order of points
uniform usamplerBuffer offsets;
uniform usamplerBuffer counts;
#else
uniform usamplerBuffer keys;
#endif

// What comes along a ray, and in a whether it is known.
vec4 incoming(uint id) {
    vec4 b = texelFetch(radiosity, id < kNoRay ? int(id) : 0);
    bool lit = id < kNoRay && b.a >= 0.0;
    return vec4(lit ? b.rgb : vec3(0.0), lit || id == kMiss ? 1.0 : 0.0);
}

#if IN_PICTURE
// What the j-th ray of a start has met; at = slot * capacity + key.
uint ray_of(int at, int j) {
    int slot = int((float(at) + 0.5) / float(capacity));
    return met(texelFetch(remembered, at + (slot * (rays - 1) + j) * capacity).r);
}
#endif

void main() {
    uint i = work_item();
    if (i >= point_count) return;
#if IN_PICTURE
    int first = int(texelFetch(offsets, int(i)).r);
    int end = first + int(texelFetch(counts, int(i)).r);
    vec3 sum = vec3(0.0);
    float squares = 0.0;
    float n = 0.0;
    for (int k = first; k < end; ++k) {
        int at = int(texelFetch(served, k).r);
        for (int j = 0; j < rays && at >= 0; ++j) {
            vec4 b = incoming(ray_of(at, j));
            float y = luminance(b.rgb);
            sum += b.rgb;
            squares += y * y;
            n += b.a;
        }
    }
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
