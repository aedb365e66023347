#version 450 core
// Direct irradiance of the listed lit texels, by the light maps: that of their middles. Those too near to a lamp for it are listed.
layout(local_size_x = 256) in;

#include "lit_direct.glsl"
#include "gi_module/techniques/emc/gather/entry_list.glsl"

// A texel's width over its distance from the nearest lamp. A face's texels are at most 2 / lit_resolution of their distance wide.
float nearness_of(int place, vec3 point, vec3 n) {
    vec3 o = point - centre_of_map(place);
    float wide = 2.0 / float(lit_resolution);
    float r2 = dot(o, o);
    float most = wide * wide * r2 / max(-dot(o, n) * inversesqrt(max(r2, 1e-30)), 1e-2);
    float near = 3.4e38;
#ifdef LAMP_TREES
    near = nearest_lamp(point, 0, other_nodes_end, near);
#else
#define LOOK_AT(LIGHT) near = min(near, dot(LIGHT.position - point, LIGHT.position - point));
    POINT_LIGHTS(LOOK_AT, 0)
    SPOT_LIGHTS(LOOK_AT, 0)
    OTHER_LIGHTS(LOOK_AT, 0)
#endif
    return sqrt(most / max(near, 1e-30));
}

void main() {
    uint i = work_item();
    if (i >= listed_count) return;
    int place = int(list[i]);
    vec4 point = texelFetch(lit_points, place);
    if (!is_lit(point)) return;
    vec3 n = point_normal(point);
    float nearness = nearness_of(place, point.xyz, n);
    set_direct(place, direct_irradiance(point.xyz, n), nearness);
    if (kNear * nearness > 1.0) list_entry(uint(place));
}
