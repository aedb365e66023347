#version 450 core
#include "scene_vertex.glsl"
#include "camera.glsl"

void main() {
    gl_Position = camera_clip_from_relative * vec4(fetch_vertex() - camera_position, 1.0);
}
