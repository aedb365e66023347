#version 450 core
// The mean over frames of the photons' power on each coarse texel, and of the area that it came to. A texel that shows
// something else than before begins anew. Takes the frame's sums.
layout(local_size_x = 256) in;

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 1) buffer Seen { vec4 seen[]; };    // the point that the mean belongs to
layout(std430, binding = 2) buffer Means { vec4 means[]; };  // rgb: lumen; a: m^2
layout(std430, binding = 3) readonly buffer Keys { uint keys[]; };
layout(std430, binding = 4) buffer UnitsHeld { float units_held[]; };  // in the mean
layout(std430, binding = 5) buffer Sums { uint sums[]; };   // rgb, two words each
#include "fixed_sums.glsl"
#include "lit_points.glsl"

uniform samplerBuffer coarse_points;  // by number
uniform usamplerBuffer areas;         // by place: two words
uniform vec3 power_unit;  // lumen
uniform float area_unit;  // m^2
uniform vec3 scale;       // of what is remembered: the lamps' power now over that before
uniform int coarse_resolution;
uniform float reach;  // of a texel's width
uniform vec4 map_centres[MAX_MAPS];
uniform float most_units;  // that the mean may hold already, of gi.gather.photons
uniform float times;       // of those, in the frame

void main() {
    uint i = work_item();
    if (i >= point_count) return;
    uint place = keys[i];
    if (place == kNoPoint) return;
    vec4 point = texelFetch(coarse_points, int(i));
    // What moves on by less than a texel still shows about the same light.
    vec4 was = seen[place];
    int slot = int(place) / (6 * coarse_resolution * coarse_resolution);
    float width = distance(point.xyz, map_centres[slot].xyz) * 2.0 / float(coarse_resolution);
    bool same = floatBitsToUint(was.w) != kUnlitPoint && dot(point_normal(point), point_normal(was)) > 0.95 &&
                distance(point.xyz, was.xyz) < reach * width;
    vec3 power;
    for (uint c = 0u; c < 3u; ++c) {
        uint at = 2u * (3u * place + c);
        power[c] = units_of(sums[at], sums[at + 1u]);
        sums[at] = 0u;
        sums[at + 1u] = 0u;
    }
    uvec2 area = uvec2(texelFetch(areas, 2 * int(place)).r, texelFetch(areas, 2 * int(place) + 1).r);
    vec4 now = vec4(power * power_unit, units_of(area.x, area.y) * area_unit);
    float held = same ? min(units_held[place], most_units) : 0.0;
    vec4 before = means[place] * vec4(scale, 1.0);
    means[place] = held > 0.0 ? mix(before, now, times / (held + times)) : now;
    units_held[place] = held + times;
    seen[place] = point;
}
