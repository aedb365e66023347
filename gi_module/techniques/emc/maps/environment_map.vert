#version 450 core
#extension GL_ARB_shader_viewport_layer_array : require
// Scene triangles into one cube face a layer; gl_InstanceID, from first_layer on, chooses the entry of `layers`.
#define KEEPS_ALBEDO
#include "engine/render/scene_vertex.glsl"
#include "engine/render/cube.glsl"

layout(std430, binding = 8) readonly buffer Layers { vec4 layers[]; };  // xyz centre, w = target layer (6 * slot + face)
layout(location = 7) in uint first_layer;  // of this draw call's
uniform float near_plane;

out vec3 from_centre;

void main() {
    vec4 layer = layers[int(first_layer) + gl_InstanceID];
    int target = int(layer.w);
    from_centre = fetch_vertex() - layer.xyz;
    gl_Position = cube_clip(target % 6, from_centre, near_plane);
    gl_Layer = target;
}
