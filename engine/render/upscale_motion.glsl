// Where a point of the picture was in the picture before.
#ifndef LANTHORN_UPSCALE_MOTION_GLSL
#define LANTHORN_UPSCALE_MOTION_GLSL

uniform vec2 shift;  // pixels: how far off its middle a pixel was looked through
// The camera of the frame before, looking through the middles.
uniform vec3 before_position;
uniform vec3 before_forward;
uniform mat4 before_clip_from_relative;

// xy: from there to here, shares of the picture (0..1 from the lower left); z: how far from that camera it was, < 0: behind it.
// `pixel`: its middle, of a picture of `size`; `relative`: the point, as it was, from before_position.
vec3 motion_from(vec2 pixel, vec2 size, vec3 relative) {
    vec4 clip = before_clip_from_relative * vec4(relative, 1.0);
    vec2 uv = clip.xy / max(clip.w, 1e-20) * 0.5 + 0.5;
    float distance = camera_orthographic != 0 ? dot(relative, before_forward) : length(relative);
    return vec3((pixel + shift) / size - uv, clip.w > 0.0 ? distance : -1.0);
}

#endif
