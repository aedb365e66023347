#version 450 core
// Pixels that show a surface and were met by no triangle, at outlines, take the light of those around them that show
// something as far away.
layout(local_size_x = 8, local_size_y = 8) in;

uniform sampler2D gbuffer_distance;
layout(rgba32f, binding = 0) uniform image2D irradiance;  // a: 1 drawn, 0 not
uniform ivec2 image_size;

const int kReach = 3;  // pixels

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, image_size))) return;
    float here = texelFetch(gbuffer_distance, pixel, 0).r;
    if (here <= 0.0 || imageLoad(irradiance, pixel).a != 0.0) return;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
            ivec2 at = pixel + ivec2(x, y);
            if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, image_size))) continue;
            vec4 there = imageLoad(irradiance, at);
            if (there.a != 1.0) continue;
            float off = abs(texelFetch(gbuffer_distance, at, 0).r - here) / here;
            float weight = 1.0 / (float(x * x + y * y) * (1e-3 + off));
            sum += weight * there.rgb;
            weights += weight;
        }
    }
    if (weights > 0.0) imageStore(irradiance, pixel, vec4(sum / weights, 0.5));
}
