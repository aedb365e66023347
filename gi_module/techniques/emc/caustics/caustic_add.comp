#version 450 core
// The final stage's irradiance with that of caustics.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D base;
uniform sampler2D caustics;
uniform int has_base;
layout(rgba32f, binding = 0) uniform writeonly image2D sum;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(sum)))) return;
    vec4 light = texelFetch(caustics, p, 0);
    imageStore(sum, p, has_base != 0 ? texelFetch(base, p, 0) + light : light);
}
