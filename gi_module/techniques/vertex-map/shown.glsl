// Whether a fragment is what the picture shows.
#ifndef LANTHORN_VERTEX_MAP_SHOWN_GLSL
#define LANTHORN_VERTEX_MAP_SHOWN_GLSL

#include "engine/render/camera.glsl"

uniform sampler2D gbuffer_distance;
uniform float pixel_spread;  // metres that a pixel is wide at a distance of one; 0: orthographic
uniform float pixel_width;   // metres, orthographic

// `relative`: to the camera. Both were interpolated over a triangle from vertices that were rounded apart, and far
// figures are drawn by coarser triangles that lie within half a pixel (GpuScene::picture_level).
bool is_shown(vec3 relative) {
    float here = camera_distance(relative);
    float seen = texelFetch(gbuffer_distance, ivec2(gl_FragCoord.xy), 0).r;
    float slope = fwidth(here);
    return seen > 0.0 && abs(here - seen) <= 0.5 * (slope + pixel_spread * seen + pixel_width);
}

#endif
