#version 450 core
// A corner with its light, where the G-buffer has its surface.
#include "engine/render/camera.glsl"

layout(location = 0) in vec3 in_position;  // render space
layout(location = 1) in vec4 in_light;     // irradiance, lux

out vec3 relative;  // to the camera
out vec3 light;

void main() {
    relative = in_position - camera_position;
    light = in_light.rgb;
    gl_Position = camera_clip_from_relative * vec4(relative, 1.0);
}
