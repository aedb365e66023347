#version 450 core
// What a gathered picture's error is estimated from (gather_error.h), summed over its points: by group, since the processor adds up
// the rest. FIRST 1: the light, for its mean. FIRST 0: all else, relative to that.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gather_surface.glsl"

const uint kGroups = 64u;  // GatherError::kGroups

// By group. FIRST 1: light, lux, and points. FIRST 0: three rows of squares.
layout(std430, binding = 4) writeonly buffer Sums { vec4 sums[]; };

uniform samplerBuffer filtered;  // by point, lux; a < 0: nothing is known
uniform samplerBuffer points;
uniform ivec2 grid;
#if !FIRST
uniform samplerBuffer irradiance;       // before the filter; a: mean square luminance of the rays
uniform samplerBuffer halves;           // half of what separates the two halves of the rays; a: share that is known
uniform samplerBuffer filtered_halves;  // the same, filtered
uniform vec3 mean;                      // of `filtered`
#endif

shared vec4 group_sums[256];

// The sum over the group's invocations, for the first of them.
vec4 sum_of_group(vec4 own) {
    uint me = gl_LocalInvocationID.x;
    barrier();
    group_sums[me] = own;
    barrier();
    for (uint step = 128u; step > 0u; step >>= 1) {
        if (me < step) group_sums[me] += group_sums[me + step];
        barrier();
    }
    return group_sums[0];
}

bool is_seen(int at) { return dot(texelFetch(points, at).xyz, texelFetch(points, at).xyz) > 0.0 && texelFetch(filtered, at).a >= 0.0; }

#if !FIRST
float mean_square(vec3 c) { return dot(c, c) * (1.0 / 3.0); }

// What light at a point is off the straight line between its neighbours, and the same of the noise: both as squares, of colours and
// of luminance. Negative: one of them is of another surface.
vec4 bend(int at, int before, int after) {
    vec4 x = texelFetch(points, at);
    vec3 n = point_normal(x);
    float slack = 1e-4 * length(x.xyz);
    vec4 a = texelFetch(points, before);
    vec4 b = texelFetch(points, after);
    bool fits = is_seen(before) && is_seen(after) && same_surface(x.xyz, n, a.xyz, point_normal(a), slack) > kSomeSurface &&
                same_surface(x.xyz, n, b.xyz, point_normal(b), slack) > kSomeSurface;
    vec3 light = texelFetch(filtered, at).rgb - 0.5 * (texelFetch(filtered, before).rgb + texelFetch(filtered, after).rgb);
    vec3 noise = texelFetch(filtered_halves, at).rgb -
                 0.5 * (texelFetch(filtered_halves, before).rgb + texelFetch(filtered_halves, after).rgb);
    float y = luminance(light);
    float y_noise = luminance(noise);
    return fits ? vec4(mean_square(light), mean_square(noise), y * y, y_noise * y_noise) : vec4(-1.0);
}
#endif

void main() {
    int count = grid.x * grid.y;
    uint me = gl_LocalInvocationID.x;
#if FIRST
    vec4 light = vec4(0.0);
    for (int i = int(gl_WorkGroupID.x * 256u + me); i < count; i += int(kGroups * 256u)) {
        light += is_seen(i) ? vec4(texelFetch(filtered, i).rgb, 1.0) : vec4(0.0);
    }
    light = sum_of_group(light);
    if (me == 0u) sums[gl_WorkGroupID.x] = light;
#else
    float over = dot(mean, vec3(1.0 / 3.0));
    float per = 1.0 / max(over * over, 1e-30);
    float y_mean = max(luminance(mean), 1e-15);
    vec4 all = vec4(0.0);    // noise, blur, bend, contrast
    vec4 local = vec4(0.0);  // the same
    vec4 rest = vec4(0.0);   // points, unknown, unknown by place, none
    for (int i = int(gl_WorkGroupID.x * 256u + me); i < count; i += int(kGroups * 256u)) {
        if (!is_seen(i)) continue;
        vec3 light = texelFetch(filtered, i).rgb;
        vec4 raw = texelFetch(irradiance, i);
        vec4 half_of = texelFetch(halves, i);
        vec3 noise = texelFetch(filtered_halves, i).rgb;
        float y = luminance(light);
        float by_place = 1.0 / (y * y + 0.01 * y_mean * y_mean);
        float y_noise = luminance(noise);
        all.x += mean_square(noise) * per;
        local.x += y_noise * y_noise * by_place;
        if (raw.a >= 0.0) {
            vec3 moved = raw.rgb - light;
            vec3 by_noise = half_of.rgb - noise;
            float y_moved = luminance(moved);
            float y_by_noise = luminance(by_noise);
            float y_raw = luminance(raw.rgb);
            all.y += (mean_square(moved) - mean_square(by_noise)) * per;
            local.y += (y_moved * y_moved - y_by_noise * y_by_noise) * by_place;
            float variance = max(raw.a - y_raw * y_raw, 0.0);
            all.w += variance / (y_mean * y_mean);
            local.w += variance * by_place;
            float lost = 1.0 - half_of.a;
            rest.y += lost * lost * mean_square(light) * per;
            rest.z += lost * lost * y * y * by_place;
        }
        ivec2 p = ivec2(i % grid.x, i / grid.x);
        if (p.x > 0 && p.x + 1 < grid.x) {
            vec4 level = bend(i, i - 1, i + 1);
            all.z += level.x < 0.0 ? 0.0 : (level.x - level.y) * per;
            local.z += level.x < 0.0 ? 0.0 : (level.z - level.w) * by_place;
        }
        if (p.y > 0 && p.y + 1 < grid.y) {
            vec4 upright = bend(i, i - grid.x, i + grid.x);
            all.z += upright.x < 0.0 ? 0.0 : (upright.x - upright.y) * per;
            local.z += upright.x < 0.0 ? 0.0 : (upright.z - upright.w) * by_place;
        }
        rest.x += 1.0;
    }
    all = sum_of_group(all);
    if (me == 0u) sums[3u * gl_WorkGroupID.x] = all;
    local = sum_of_group(local);
    if (me == 0u) sums[3u * gl_WorkGroupID.x + 1u] = local;
    rest = sum_of_group(rest);
    if (me == 0u) sums[3u * gl_WorkGroupID.x + 2u] = rest;
#endif
}
