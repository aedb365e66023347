#version 450 core
// What a point of an emissive surface sees in the hemisphere that it shines into.
#include "engine/render/material.glsl"
#include "engine/render/octahedral.glsl"

layout(location = 0) out float out_distance;
layout(location = 1) out vec2 out_normal;
layout(location = 2) out vec4 out_albedo;

uniform vec3 light_position;
uniform vec3 light_direction;

void main() {
    vec3 q = scene.position - light_position;
    float distance = length(q);
    vec3 normal = geometric_direction(-q, -q);
    SurfaceMaterial m = evaluate_diffuse();
    // The emitter's own plane does not hide what it shines on.
    if (dot(q, light_direction) < 1e-3 * distance) discard;
#ifdef MASKED
    if (material_cut_out(m.alpha)) discard;
#endif
    out_distance = distance;
    out_normal = octahedral_encode(normal);
    out_albedo = albedo_to_keep(m);
}
