#version 450 core
// From the gathered picture to the mean of a still picture's own rays.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform writeonly image2D picture;

uniform sampler2D first;
uniform samplerBuffer irradiance;  // by pixel, lux; a < 0: nothing is known
uniform float weight;              // of what the rays say

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(picture);
    if (any(greaterThanEqual(p, size))) return;
    vec4 own = texelFetch(irradiance, p.y * size.x + p.x);
    imageStore(picture, p, vec4(mix(texelFetch(first, p, 0).rgb, own.rgb, own.a >= 0.0 ? weight : 0.0), 0.0));
}
