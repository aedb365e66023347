#version 450 core
// What rays bring of specular reflections, and glossy splats; and what these lobes reflect of caustics, by their irradiance.
layout(local_size_x = 8, local_size_y = 8) in;

#include "gi_module/shared/mirrors/specular_pixel.glsl"

uniform sampler2D traced;  // by rays: radiance, share of the lobe
uniform sampler2D glossy;
uniform sampler2D caustics;
uniform int has_traced;
uniform int has_caustics;
layout(rgba32f, binding = 0) uniform writeonly image2D sum;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, image_size))) return;
    vec4 result = has_traced != 0 ? texelFetch(traced, p, 0) : vec4(0.0);
    vec4 lobe = texelFetch(glossy, p, 0);
    if (lobe.a > 0.0) {
        result += lobe;
        SpecularPixel s = specular_pixel(p);
        vec3 light = has_caustics != 0 ? texelFetch(caustics, p, 0).rgb : vec3(0.0);
        result.rgb += light * s.specular * (lobe.a * s.occlusion / 3.14159265359);
    }
    imageStore(sum, p, result);
}
