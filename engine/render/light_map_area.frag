#version 450 core
// What one point of an emissive surface sees: distances alone, in the hemisphere it shines into.
#include "material.glsl"
#include "lights.glsl"

layout(location = 0) out float out_distance;

uniform int light_index;

void main() {
    vec3 q = scene.position - lights[light_index].position;
    float distance = length(q);
    // The emitter's own plane does not shade it.
    float height = dot(q, lights[light_index].direction);
    if (lights[light_index].two_sided != 0u) height = abs(height);
    if (height < 1e-3 * distance) discard;
    if (material_cut_out(material_base().a)) discard;
    out_distance = distance;
}
