#version 450 core
// What one point of an emissive surface sees in the hemisphere it shines into: for shadows alone.
#include "material.glsl"
#include "octahedral.glsl"

layout(location = 0) out float out_distance;
layout(location = 1) out vec2 out_normal;

uniform vec3 light_position;
uniform vec3 light_direction;
uniform int two_sided;
uniform vec3 light_middle;  // LightData::up and depth_range: what the point stands for
uniform float light_reach;

// What the point stands for may bend before its plane, as a ring does: that shades the point, but not the rest of it.
const float kBends = 0.35;  // height over distance

void main() {
    vec3 q = scene.position - light_position;
    float distance = length(q);
    vec3 normal = geometric_direction(-q, -q);
    // The emitter's own plane does not shade it.
    float height = dot(q, light_direction);
    if ((two_sided != 0 ? abs(height) : height) < 1e-3 * distance) discard;
    vec3 off = scene.position - light_middle;
    bool may_be_own = abs(height) < kBends * distance && dot(off, off) <= light_reach * light_reach;
    if (may_be_own && material_emission() != vec3(0.0)) discard;
#ifdef MASKED
    if (material_cut_out(material_base().a)) discard;
#endif
    out_distance = distance;
    out_normal = octahedral_encode(normal);
}
