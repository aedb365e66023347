#version 450 core
// Irradiance at points: the mean of what the lit texels reflect that their rays have met, and the mean square of its luminance.
// What no lit texel shows is left out of the mean; where that is more than half of what there is to meet, the rest of it is dark.
// Of what has its own albedo instead (more_albedo()) direct light is known; of the rest it has as much as the point: E = (sum + a E) / n.
// IN_PICTURE 1: rays of a point are a list in ascending order, and weighted. 0: they are those of its key, in theirs. RAYS: `rays`,
// so that loops are unrolled. HALVES 1: also what separates the rays of even and odd numbers.
layout(local_size_x = 256) in;

#include "remembered.glsl"
#include "gather_surface.glsl"

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 1) writeonly buffer Irradiance { vec4 irradiance[]; };  // lux; a: lux^2, -1: nothing is known
layout(std430, binding = 2) writeonly buffer Known { float known[]; };           // rays behind it
#if HALVES
// Lux: half the difference of what either half of the rays says; a: the share of what they met that is known, -1: nothing is.
layout(std430, binding = 6) writeonly buffer Halves { vec4 halves[]; };
#endif

uniform samplerBuffer radiosity;  // by place, lux; a < 0: not lit; from more_first on > 0: more_albedo()
uniform int more_first;           // place; 0: there are none
uniform usamplerBuffer remembered;
#if IN_PICTURE
uniform usamplerBuffer served;  // starts, in the order of points
uniform usamplerBuffer offsets;
uniform usamplerBuffer counts;
#else
uniform usamplerBuffer keys;
#endif

const float kLeastShare = 0.5;  // that counts as known: what is left out doubles the light of a point at most

vec3 sum = vec3(0.0);
float squares = 0.0;
float all_rays = 0.0;
vec2 weights = vec2(0.0);  // of rays that met what a lit texel shows, or the sky; of all
vec3 more = vec3(0.0);     // albedo of what reflects more than is known, by weight
#if HALVES
vec3 sum_odd = vec3(0.0);
float rays_odd = 0.0;
vec2 weights_odd = vec2(0.0);
vec3 more_odd = vec3(0.0);
#endif

void add_ray(uint ray, bool odd) {
    uint id = met(ray);
    vec4 b = texelFetch(radiosity, id < kNoRay ? int(id) : 0);
    bool lit = id < kNoRay && b.a >= 0.0;
    float w = IN_PICTURE != 0 ? ray_weight(ray) : 1.0;
    vec3 e = lit ? w * b.rgb : vec3(0.0);
    float y = luminance(e);
    sum += e;
    squares += y * y;
    all_rays += id == kNoRay ? 0.0 : 1.0;
    weights += id == kNoRay ? vec2(0.0) : vec2(lit ? w : 0.0, w);
    vec3 a = lit && more_first > 0 && int(id) >= more_first && b.a > 0.0 ? w * more_albedo(b.a) : vec3(0.0);
    more += a;
#if HALVES
    sum_odd += odd ? e : vec3(0.0);
    rays_odd += odd && id != kNoRay ? 1.0 : 0.0;
    weights_odd += odd && id != kNoRay ? vec2(lit ? w : 0.0, w) : vec2(0.0);
    more_odd += odd ? a : vec3(0.0);
#endif
}

// By weight, since that is how guided rays know: many that count little are no more than one that counts much.
float share_of(vec2 of) { return of.x / max(of.y, 1e-3); }

vec4 mean_of(vec4 of, float rays_of, vec2 by, vec3 more_of) {
    vec3 share = max(vec3(share_of(by)) - more_of / max(by.y, 1e-3), vec3(kLeastShare));
    return of / max(rays_of * vec4(share, dot(share, vec3(1.0 / 3.0))), vec4(1e-3));
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
        for (int j = 0; j < RAYS; ++j) {
            uint ray = texelFetch(remembered, max(at, 0) + (slot * (RAYS - 1) + j) * capacity).r;
            add_ray(at >= 0 ? ray : kNoRay, (slot * RAYS + j) % 2 == 1);
        }
    }
#else
    int key = int(texelFetch(keys, int(i)).r);
    if (uint(key) == kNoPoint) return;
    for (int k = 0; k < int(kRemembered) * RAYS; ++k) add_ray(texelFetch(remembered, k * capacity + key).r, k % 2 == 1);
#endif
    vec4 mean = mean_of(vec4(sum, squares), all_rays, weights, more);
    irradiance[i] = vec4(mean.rgb, weights.x > 0.0 ? mean.a : -1.0);
    known[i] = all_rays * share_of(weights);
#if HALVES
    vec2 weights_even = weights - weights_odd;
    vec3 odd = mean_of(vec4(sum_odd, 0.0), rays_odd, weights_odd, more_odd).rgb;
    vec3 even = mean_of(vec4(sum - sum_odd, 0.0), all_rays - rays_odd, weights_even, more - more_odd).rgb;
    // Where one half knows nothing, the other one may be wrong by all it says.
    bool both = weights_odd.x > 0.0 && weights_even.x > 0.0;
    halves[i] = vec4(both ? 0.5 * (even - odd) : mean.rgb, weights.x > 0.0 ? share_of(weights) : -1.0);
#endif
}
