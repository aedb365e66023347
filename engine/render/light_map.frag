#version 450 core
// What a punctual light sees: shadow map and photon emission map at once.
#include "material.glsl"
#include "lights.glsl"
#include "octahedral.glsl"

layout(location = 0) out float out_distance;
layout(location = 1) out vec2 out_normal;
layout(location = 2) out vec4 out_albedo;

uniform int light_index;

void main() {
    vec3 q = scene.position - lights[light_index].position;
    bool directional = lights[light_index].type == kLightDirectional;
    vec3 normal = geometric_normal(directional ? -lights[light_index].direction : -q);
    SurfaceMaterial m = evaluate_diffuse();
    if (material_cut_out(m.alpha)) discard;
    out_distance = directional ? dot(q, lights[light_index].direction) : length(q);
    out_normal = octahedral_encode(normal);
    out_albedo = vec4(diffuse_albedo(m), 1.0);
}
