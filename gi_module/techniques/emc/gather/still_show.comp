#version 450 core
// From the gathered picture to the mean of a still picture's own rays.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform writeonly image2D picture;
layout(rgba16f, binding = 1) uniform writeonly image2D corrections;  // the picture over `first`

uniform sampler2D first;
uniform samplerBuffer irradiance;  // by pixel, lux; a < 0: nothing is known
uniform float weight;              // of what the rays say

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(picture);
    if (any(greaterThanEqual(p, size))) return;
    vec4 own = texelFetch(irradiance, p.y * size.x + p.x);
    vec3 gathered = texelFetch(first, p, 0).rgb;
    vec3 light = mix(gathered, own.rgb, own.a >= 0.0 ? weight : 0.0);
    imageStore(picture, p, vec4(light, 0.0));
    const float kMost = 1.25;  // more would be seen where the light that comes is quite another
    imageStore(corrections, p, vec4(clamp(light / max(gathered, vec3(1e-20)), 1.0 / kMost, kMost), 0.0));
}
