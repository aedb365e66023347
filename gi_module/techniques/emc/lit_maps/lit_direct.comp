#version 450 core
// Direct irradiance of the listed lit texels, by the light maps: that of their middles. Those too near to a lamp for it are listed.
layout(local_size_x = 256) in;

#include "lit_direct.glsl"
#include "gi_module/techniques/emc/gather/entry_list.glsl"

// Whether a lamp may be nearer than kNear texel widths. A face's texels are at most 2 / lit_resolution of their distance wide.
bool is_near_a_lamp(int place, vec3 point, vec3 n) {
    vec3 o = point - centre_of_map(place);
    float wide = 2.0 * kNear / float(lit_resolution);
    float r2 = dot(o, o);
    float most = wide * wide * r2 / max(-dot(o, n) * inversesqrt(max(r2, 1e-30)), 1e-2);
    bool near = false;
#define LOOK_AT(LIGHT) near = near || dot(LIGHT.position - point, LIGHT.position - point) < most;
    POINT_LIGHTS(LOOK_AT)
    SPOT_LIGHTS(LOOK_AT)
    OTHER_LIGHTS(LOOK_AT)
    return near;
}

void main() {
    uint i = work_item();
    if (i >= listed_count) return;
    int place = int(list[i]);
    vec4 point = texelFetch(lit_points, place);
    vec3 n = point_normal(point);
    set_direct(place, direct_irradiance(point.xyz, n));
    if (is_near_a_lamp(place, point.xyz, n)) list_entry(uint(place));
}
