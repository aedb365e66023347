#version 450 core
// What a punctual light sees: shadow map and photon emission map at once.
#include "material.glsl"
#include "octahedral.glsl"

layout(location = 0) out float out_distance;
layout(location = 1) out vec2 out_normal;
layout(location = 2) out vec4 out_albedo;

uniform vec3 light_position;
uniform vec3 light_direction;
uniform int directional;

void main() {
    vec3 q = scene.position - light_position;
    vec3 towards = directional != 0 ? -light_direction : -q;
    vec3 normal = geometric_direction(towards, towards);
    SurfaceMaterial m = evaluate_diffuse();
#ifdef MASKED  // a shader that may discard tests depth late, even where it does not
    if (material_cut_out(m.alpha)) discard;
#endif
    out_distance = directional != 0 ? dot(q, light_direction) : length(q);
    out_normal = octahedral_encode(normal);
    out_albedo = albedo_to_keep(m);
}
