#version 450 core
// Takes one pass's irradiance into the mean of all.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D image;
layout(rgba32f, binding = 0) uniform image2D mean;
uniform float weight;  // of this pass: 1 / passes

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(mean)))) return;
    vec4 now = texelFetch(image, p, 0);
    vec4 before = imageLoad(mean, p);
    imageStore(mean, p, weight < 1.0 ? mix(before, now, weight) : now);  // at first the mean holds nothing
}
