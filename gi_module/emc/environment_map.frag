#version 450 core
// What a map holds of a surface: its plane as n / dot(n, p), its distance, its diffuse albedo (see intersection.glsl).
#include "engine/render/material.glsl"

in vec3 from_centre;
layout(location = 0) out vec4 plane;
#if WITH_ALBEDO
layout(location = 1) out vec4 albedo;
#endif

void main() {
    vec3 n = geometric_normal(-from_centre);
    float distance_p = length(from_centre);
    // At grazing angles dot(n, p) vanishes: kept above what half a texel of any map can tell from 0.
    float support = min(dot(n, from_centre), -1e-4 * distance_p);
    bool single_sided = (materials[scene.material].flags & kMaterialDoubleSided) == 0u;
    bool back = single_sided && dot(scene.normal, from_centre) > 0.1 * distance_p;
    plane = vec4(n / support, back ? -distance_p : distance_p);
#if WITH_ALBEDO
    SurfaceMaterial m = evaluate_material();
    if (material_cut_out(m.alpha)) discard;
    albedo = vec4(m.unlit ? vec3(0.0) : diffuse_albedo(m), 1.0);
#else
    if (material_cut_out(material_base().a)) discard;
#endif
}
