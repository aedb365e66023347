#version 450 core
// Irradiance at points: the mean of what the lit texels reflect that their rays have met, and the mean square of its luminance.
// What no lit texel shows is left out of the mean. IN_PICTURE 1: rays of a point are a list in ascending order, and weighted. 0:
// they are those of its key, in theirs.
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

vec3 sum = vec3(0.0);
float squares = 0.0;
float known_rays = 0.0;  // that met what a lit texel shows, or the sky
float all = 0.0;         // what the weights of these sum to, but for noise

void add_ray(uint ray) {
    uint id = met(ray);
    vec4 b = texelFetch(radiosity, id < kNoRay ? int(id) : 0);
    bool lit = id < kNoRay && b.a >= 0.0;
    float w = IN_PICTURE != 0 ? ray_weight(ray) : 1.0;
    vec3 e = lit ? w * b.rgb : vec3(0.0);
    float y = luminance(e);
    sum += e;
    squares += y * y;
    known_rays += lit ? 1.0 : 0.0;
    all += id == kNoRay ? 0.0 : 1.0 - (lit ? 0.0 : w);
}

void main() {
    uint i = work_item();
    if (i >= point_count) return;
#if IN_PICTURE
    int first = int(texelFetch(offsets, int(i)).r);
    int end = first + int(texelFetch(counts, int(i)).r);
    for (int k = first; k < end; ++k) {
        int at = int(texelFetch(served, k).r);
        int slot = int((float(at) + 0.5) / float(capacity));
        for (int j = 0; j < rays && at >= 0; ++j) add_ray(texelFetch(remembered, at + (slot * (rays - 1) + j) * capacity).r);
    }
#else
    int key = int(texelFetch(keys, int(i)).r);
    for (int k = 0; k < int(kRemembered) * rays; ++k) add_ray(texelFetch(remembered, k * capacity + key).r);
#endif
    all = max(all, 0.25 * known_rays);
    irradiance[i] = vec4(sum / max(all, 1e-3), known_rays > 0.0 ? squares / all : -1.0);
    known[i] = known_rays;
}
