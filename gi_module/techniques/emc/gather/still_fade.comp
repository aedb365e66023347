#version 450 core
// The gathered picture, corrected by so much as is left of what passes of a still picture have found before light changed.
layout(local_size_x = 8, local_size_y = 8) in;

layout(rgba32f, binding = 0) uniform writeonly image2D picture;

uniform sampler2D gathered;
uniform sampler2D corrections;  // factors
uniform float left;             // 1: all of them

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(picture)))) return;
    vec3 factors = mix(vec3(1.0), texelFetch(corrections, p, 0).rgb, left);
    imageStore(picture, p, vec4(texelFetch(gathered, p, 0).rgb * factors, 0.0));
}
