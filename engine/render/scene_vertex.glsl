// A vertex of the scene in render space. For vertex shaders drawn by GpuScene::draw: gl_InstanceID is the layer.
#ifndef LANTHORN_SCENE_VERTEX_GLSL
#define LANTHORN_SCENE_VERTEX_GLSL
#include "engine/render/include/lanthorn/render/scene_structs.h"
#include "engine/scene/include/lanthorn/scene/diffuse_reflectance.h"
#define SCENE_VARYING out
#include "scene_varyings.glsl"

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec3 in_normal;
layout(location = 2) in vec4 in_tangent;
layout(location = 3) in vec2 in_uv0;
layout(location = 4) in vec2 in_uv1;
layout(location = 5) in vec4 in_colour;
layout(location = 6) in uint in_instance;  // advances by baseInstance alone

layout(std430, binding = 0) readonly buffer Instances {
    InstanceData instances[];
};

layout(std430, binding = 1) readonly buffer Materials {
    MaterialData materials[];
};

// Fills the varyings that material.glsl reads and returns the position in render space.
vec3 fetch_vertex() {
    mat4 m = instances[in_instance].object_to_render;
    mat3 n = mat3(instances[in_instance].normal_x.xyz, instances[in_instance].normal_y.xyz,
                  instances[in_instance].normal_z.xyz);
    scene.position = (m * vec4(in_position, 1.0)).xyz;
    scene.normal = normalize(n * in_normal);
    scene.tangent = vec4(mat3(m) * in_tangent.xyz, in_tangent.w * instances[in_instance].mirror);
    scene.uv = vec4(in_uv0, in_uv1);
    uint material = instances[in_instance].material;
    float r = (materials[material].ior - 1.0) / (materials[material].ior + 1.0);
    vec4 factor = materials[material].base_colour;
#ifdef KEEPS_ALBEDO  // for albedo_to_keep()
    bool numbered = material < kNumberedMaterials;
    factor.rgb = numbered ? vec3(1.0) : factor.rgb;
    vec4 reflects = materials[material].reflects;
    scene.kept = vec3(base_reflectance(materials[material].metallic, materials[material].transmission,
                                       materials[material].roughness, reflects.y, reflects.z),
                      reflects.x, numbered ? float(material + 1u) : 0.0);
#endif
    scene.colour = in_colour * factor;
    scene.lobes = vec4(materials[material].metallic, materials[material].roughness, materials[material].transmission,
                       r * r);
    scene.flags = materials[material].flags;
    scene.material = material;
    scene.instance = in_instance;
    return scene.position;
}

#endif
