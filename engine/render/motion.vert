#version 450 core
// What moves, where it is and where it was.
#include "scene_vertex.glsl"
#include "camera.glsl"

layout(location = 7) in uint in_mover;
layout(location = 8) in vec3 in_before;  // object space

layout(std430, binding = 2) readonly buffer Before {
    mat4 before_to_render[];  // by mover
};

out vec3 position_before;  // render space

void main() {
    gl_Position = camera_clip_from_relative * vec4(fetch_vertex() - camera_position, 1.0);
    position_before = (before_to_render[in_mover] * vec4(in_before, 1.0)).xyz;
}
