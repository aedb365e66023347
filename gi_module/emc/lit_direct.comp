#version 450 core
// Direct irradiance of the lit texels, by the light maps, and what they reflect of it.
layout(local_size_x = 256) in;

#include "engine/render/direct_irradiance.glsl"
#include "point_lists.glsl"
#define BAD_VALUES_BINDING 7
#include "bad_values.glsl"

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 1) readonly buffer Points { vec4 points[]; };
layout(std430, binding = 3) readonly buffer Keys { uint keys[]; };
layout(std430, binding = 4) readonly buffer Albedo { vec4 albedo[]; };
layout(std430, binding = 5) writeonly buffer Direct { vec4 direct[]; };        // lux
layout(std430, binding = 6) writeonly buffer First { vec4 first[]; };          // by place, lux

void main() {
    uint i = work_item();
    if (i >= point_count) return;
    vec4 point = points[i];
    vec3 e = direct_irradiance(point.xyz, point_normal(point));
    if (is_bad(e)) {
        atomicAdd(bad_value_count, 1u);
        e = vec3(0.0);
    }
    direct[i] = vec4(e, 0.0);
    first[keys[i]] = vec4(albedo[i].rgb * e, 0.0);
}
