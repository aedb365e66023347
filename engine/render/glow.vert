#version 450 core
// A rectangle around each flame, which faces the camera as far as its axis lets it: two triangles.
#include "camera.glsl"
#include "strip_data.h"

layout(std430, binding = 0) readonly buffer PictureGlows {
    PictureGlow glows[];
};

layout(location = 0) out vec2 flame_at;  // across: -1..1 of its width; along: 0 foot, 1 tip
layout(location = 1) flat out vec3 flame_nits;

void main() {
    PictureGlow glow = glows[gl_InstanceID];
    vec3 axis = glow.tip.xyz - glow.foot.xyz;
    vec3 middle = 0.5 * (glow.tip.xyz + glow.foot.xyz);
    vec3 sight = normalize(camera_orthographic != 0 ? camera_forward : middle);
    vec3 across = cross(sight, axis);
    // Straight from above or below it is a disc.
    across = length(across) > 0.02 * length(axis) ? normalize(across) : normalize(camera_right);
    vec3 along = normalize(cross(across, sight));
    float half_long = max(0.5 * abs(dot(axis, along)), 0.5 * glow.foot.a);
    vec2 corner = vec2((gl_VertexID & 1) != 0 ? 1.0 : -1.0, (gl_VertexID & 2) != 0 ? 1.0 : -1.0);
    float up = dot(axis, along) < 0.0 ? -corner.y : corner.y;
    flame_at = vec2(corner.x, 0.5 + 0.5 * up);
    flame_nits = glow.nits.rgb;
    vec3 place = middle + 0.5 * glow.foot.a * corner.x * across + half_long * corner.y * along;
    gl_Position = camera_clip_from_relative * vec4(place, 1.0);
}
