#version 450 core
// How far what moves has come in the picture: see upscale_motion.glsl.
#define SCENE_VARYING in
#include "scene_varyings.glsl"
#include "camera.glsl"
#include "upscale_motion.glsl"

layout(location = 0) out vec4 out_motion;

uniform sampler2D gbuffer_distance;

in vec3 position_before;

const float kSamePlace = 1e-3;  // of the distance: the G-buffer has drawn the same triangle there

void main() {
    float seen = texelFetch(gbuffer_distance, ivec2(gl_FragCoord.xy), 0).r;
    if (abs(camera_distance(scene.position - camera_position) - seen) > kSamePlace * seen) discard;
    vec2 size = vec2(textureSize(gbuffer_distance, 0));
    out_motion = vec4(motion_from(gl_FragCoord.xy, size, position_before - before_position), 1.0);
}
