// Instances and materials as the shaders read them (std430). Included by C++ and by GLSL: keep to both.
#ifndef LANTHORN_SCENE_STRUCTS_H
#define LANTHORN_SCENE_STRUCTS_H

#ifdef __cplusplus
#include "lanthorn/core/math.h"

namespace lanthorn::render {
#endif

// Storage buffer bindings that GpuScene::bind() fills.
const uint kInstancesBinding = 0u;
const uint kMaterialsBinding = 1u;
const uint kKeptMaterialsBinding = 9u;  // of kept_albedo.glsl: GpuScene::bind_materials()

// A shape in its place, as shaders read it.
struct InstanceData {
    mat4 object_to_render;
    vec4 normal_x;  // columns of the matrix that takes normals to render space (not unit; w unused)
    vec4 normal_y;
    vec4 normal_z;
    uint material;
    uint id;       // Instance::id
    float mirror;  // -1 where the transform mirrors, else 1
    uint reserved;
};

// Bits of MaterialData::flags. Bit i, i < 8: texture i is present (unit i):
// 0 base colour, 1 metallic-roughness, 2 normal, 3 occlusion, 4 emissive, 5 specular, 6 specular colour, 7
// transmission.
const uint kMaterialUnlit = 1u << 8;
const uint kMaterialDoubleSided = 1u << 9;
const uint kMaterialMask = 1u << 10;
const uint kMaterialBlend = 1u << 11;
const uint kMaterialEmits = 1u << 12;
const uint kMaterialSpecular = 1u << 13;  // KHR_materials_specular says other than its defaults

// A material, as shaders read it.
struct MaterialData {
    vec4 base_colour;      // linear RGBA factor
    vec4 emissive;         // nits, rgb; w = alpha cutoff
    vec4 specular_colour;  // rgb; w = KHR_materials_specular's strength
    vec4 reflects;         // MaterialReflectance: boundary, transmittance, evenly
    vec4 volume;  // rgb: absorption in 1/m; w = thickness in m (KHR_materials_volume), 0: a thin wall
    float metallic;
    float roughness;
    float normal_scale;
    float occlusion_strength;
    float ior;
    float transmission;
    uint flags;
    uint uv_sets;           // bit i: texture i reads UV set 1
    vec4 uv_transform[16];  // texture i: rows 2i and 2i+1, xyz of each
};

// Maps that keep for later what reflects light (light maps, environment maps) store what of the base colour
// is reflected, without the base colour's factor, and beside it the material's slot + 1; the factor comes
// where the map is read, so that another one leaves the map as it is. Half floats count to 2048: of slots
// from here on maps store the whole albedo, and 0.
const uint kNumberedMaterials = 2047u;

#ifdef __cplusplus
static_assert(sizeof(InstanceData) == 128);
static_assert(sizeof(MaterialData) == 112 + 256);
}  // namespace lanthorn::render
#endif
#endif
