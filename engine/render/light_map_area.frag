#version 450 core
// What one point of an emissive surface sees: distances alone, in the hemisphere it shines into.
#include "material.glsl"

layout(location = 0) out float out_distance;

uniform vec3 light_position;
uniform vec3 light_direction;
uniform int two_sided;

void main() {
    vec3 q = scene.position - light_position;
    float distance = length(q);
    // The emitter's own plane does not shade it.
    float height = dot(q, light_direction);
    if ((two_sided != 0 ? abs(height) : height) < 1e-3 * distance) discard;
#ifdef MASKED
    if (material_cut_out(material_base().a)) discard;
#endif
    out_distance = distance;
}
