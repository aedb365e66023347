// What the passes of fxaa.h share.
#ifndef LANTHORN_FXAA_GLSL
#define LANTHORN_FXAA_GLSL

layout(std430, binding = 0) buffer Edges {
    uint groups_x, groups_y, groups_z;  // of fxaa_smooth.comp
    uint count;
    uint pixels[];  // x + width * y of each pixel on an edge, in any order
} edges;

uniform sampler2D picture;  // encoded for display

const uint kSmoothGroup = 64u;
const uint kRow = 16384u;  // work groups a row of a dispatch: GL promises no more than 65535

vec3 colour_at(ivec2 p) {
    return texelFetch(picture, clamp(p, ivec2(0), textureSize(picture, 0) - 1), 0).rgb;
}

float luma(vec3 colour) {
    return dot(colour, vec3(0.299, 0.587, 0.114));
}

float luma_at(ivec2 p) {
    return luma(colour_at(p));
}

#endif
