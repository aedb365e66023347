// Albedo for light that is bounced on (engine/scene/include/lanthorn/scene/diffuse_reflectance.h) out of a map that keeps it without the base colour's factor
// (kNumberedMaterials says why), for compute shaders.
#ifndef LANTHORN_KEPT_ALBEDO_GLSL
#define LANTHORN_KEPT_ALBEDO_GLSL
#include "engine/render/include/lanthorn/render/scene_structs.h"

layout(std430, binding = 9) readonly buffer KeptMaterials { MaterialData kept_materials[]; };  // kKeptMaterialsBinding

vec3 kept_albedo(vec4 texel) {
    uint number = uint(texel.a);
    if (number == 0u) return texel.rgb;
    vec3 base = kept_materials[number - 1u].base_colour.rgb;
    return min(texel.rgb * base + kept_materials[number - 1u].reflects.x, vec3(1.0));
}

#endif
