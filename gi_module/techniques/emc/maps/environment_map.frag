#version 450 core
// What a map holds of a surface. TRACING 1: its plane, in 8 bytes, and what it reflects of even light (see intersection.glsl, kept_albedo.glsl); CASTER 1: its smooth normal instead. TRACING 0: its
// plane as n / dot(n, p), and its distance, negative where a single-sided surface shows its back (see coverage.comp).
#include "engine/render/material.glsl"
#include "engine/render/octahedral.glsl"

uniform float screen_cell;  // metres: what is blended is open or solid by cells of this size

in vec3 from_centre;
#if TRACING
layout(location = 0) out uvec2 plane;
layout(location = 1) out vec4 albedo;
#else
layout(location = 0) out vec4 plane;
#endif

void main() {
    vec3 n = geometric_normal(-from_centre);
    float distance_p = length(from_centre);
    // At grazing angles dot(n, p) vanishes: kept above what half a texel of any map can tell from 0.
#if TRACING
    SurfaceMaterial m = evaluate_material();
    if (material_open(m.alpha, screen_cell)) discard;
#if CASTER
    bool numbered = scene.material < kNumberedMaterials;
    albedo = vec4(normalize(scene.normal), numbered ? float(scene.material + 1u) : 0.0);
#else
    albedo = albedo_to_keep(m);
#endif
    uint kept = packSnorm2x16(octahedral_encode(n));
    vec3 v = octahedral_vector(unpackSnorm2x16(kept));
    float support = min(dot(v, from_centre), -1e-4 * distance_p * length(v));
    plane = uvec2(kept, floatBitsToUint(1.0 / support));
#else
    if (material_open(material_base().a, screen_cell)) discard;
    bool single_sided = (materials[scene.material].flags & kMaterialDoubleSided) == 0u;
    bool back = single_sided && dot(scene.normal, from_centre) > 0.1 * distance_p;
    float support = min(dot(n, from_centre), -1e-4 * distance_p);
    plane = vec4(n / support, back ? -distance_p : distance_p);
    // A wall of two sheets in one place: the one whose front is seen counts, a centre in front of it is in the open.
    gl_FragDepth = gl_FragCoord.z * (back ? 0.999 : 1.0);
#endif
}
