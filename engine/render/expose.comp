#version 450 core
// Measures the picture's surfaces on a grid of 64 x 64 points, or, where none of them is lit, what is seen around and through them (the
// sky), and moves the exposure towards it: one work group.
#include "composite_state.glsl"

layout(local_size_x = 256) in;

uniform sampler2D radiance;
uniform int manual;
uniform float manual_exposure;
uniform float compensation;  // factor
uniform float darkest;       // nits: below this average the exposure rises no further
uniform float rate;          // share of the way (in stops) taken this frame; 1: all

const int kGrid = 64;
const float kKey = 0.18;  // what the average luminance becomes
const float kUsualFloor = 0.1;   // nits: what is darker counts as this in a picture whose mean is a nit or more
const float kFaintFloor = 0.1;   // of the mean: as this in a fainter one
shared float sums[256];
shared float counts[256];

vec3 radiance_at(int index, float alpha) {
    ivec2 size = textureSize(radiance, 0);
    vec2 cell = (vec2(index % kGrid, index / kGrid) + 0.5) / float(kGrid);
    vec4 texel = texelFetch(radiance, min(ivec2(cell * vec2(size)), size - 1), 0);
    return texel.a == alpha ? texel.rgb : vec3(0.0);
}

float luminance_at(int index, float alpha) { return dot(radiance_at(index, alpha), vec3(0.2126, 0.7152, 0.0722)); }

// Sum over the group of (value, count); every thread returns it.
vec2 total(float value, float count) {
    uint i = gl_LocalInvocationIndex;
    barrier();
    sums[i] = value;
    counts[i] = count;
    for (uint step = 128u; step > 0u; step >>= 1u) {
        barrier();
        if (i < step) {
            sums[i] += sums[i + step];
            counts[i] += counts[i + step];
        }
    }
    barrier();
    return vec2(sums[0], counts[0]);
}

// What even light around the picture's things is like: the mean of its lit points of `alpha`, as much as their average if that is less.
void measure_around(float alpha, float count, float mean, float average) {
    vec3 sum = vec3(0.0);
    for (int i = int(gl_LocalInvocationIndex); i < kGrid * kGrid; i += 256) sum += radiance_at(i, alpha);
    vec2 red_green = total(sum.r, sum.g);
    float blue = total(sum.b, 0.0).x;
    if (gl_LocalInvocationIndex != 0u) return;
    vec3 colour = vec3(red_green, blue) / max(count, 1.0);
    state.around = vec4(colour * min(average / max(mean, 1e-20), 1.0), 0.0);
}

// Sum and number of the lit points of `alpha` (combine.frag).
vec2 lit_points(float alpha) {
    float sum = 0.0;
    float count = 0.0;
    for (int i = int(gl_LocalInvocationIndex); i < kGrid * kGrid; i += 256) {
        float l = luminance_at(i, alpha);
        sum += l;
        count += l > 0.0 ? 1.0 : 0.0;
    }
    return total(sum, count);
}

void main() {
    float alpha = 1.0;
    vec2 lit = lit_points(alpha);
    if (lit.y < 1.0) {
        alpha = 0.0;
        lit = lit_points(alpha);
    }
    // Deep shadow counts as a thousandth of the mean, lest black corners blow out what is lit.
    float mean = lit.x / max(lit.y, 1.0);
    float floor_luminance = max(max(1e-3 * mean, min(kFaintFloor * mean, kUsualFloor)), darkest);
    float log_sum = 0.0;
    for (int i = int(gl_LocalInvocationIndex); i < kGrid * kGrid; i += 256) {
        float l = luminance_at(i, alpha);
        if (l > 0.0) log_sum += log2(max(l, floor_luminance));
    }
    vec2 logs = total(log_sum, 0.0);
#ifdef WITH_AROUND
    measure_around(alpha, lit.y, mean, exp2(logs.x / max(lit.y, 1.0)));
#endif
    if (gl_LocalInvocationIndex != 0u) return;
    if (manual != 0) {
        state.exposure = manual_exposure * compensation;
        return;
    }
    if (lit.y < 1.0) {  // nothing lit: stay
        if (state.exposure <= 0.0) state.exposure = compensation;
        return;
    }
    state.average_luminance = exp2(logs.x / lit.y);
    float target = kKey / state.average_luminance * compensation;
    float from = state.exposure > 0.0 ? state.exposure : target;
    state.exposure = exp2(mix(log2(from), log2(target), rate));
}
