#version 450 core
// What the rays of listed pixels bring, into the picture: the mean over pixels near by on the same surface.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gather_surface.glsl"

layout(rgba32f, binding = 0) uniform writeonly image2D picture;

uniform samplerBuffer points;
uniform samplerBuffer irradiance;  // lux; a < 0: nothing is known
uniform usamplerBuffer pixels;
uniform int pixel_count;
uniform int width;  // of the picture

const float kSpread = 0.5;  // 1 over twice the variance, pixels

ivec2 pixel_of(int i) {
    int pixel = int(texelFetch(pixels, i).r);
    return ivec2(pixel % width, pixel / width);
}

void main() {
    int i = int(work_item());
    if (i >= pixel_count) return;
    vec4 point = texelFetch(points, i);
    vec3 n = point_normal(point);
    ivec2 p = pixel_of(i);
    vec4 sum = vec4(0.0);
    int k = 0;
    do {
        vec4 other = texelFetch(points, k);
        vec4 e = texelFetch(irradiance, k);
        vec2 off = vec2(pixel_of(k) - p);
        float w = e.a >= 0.0 ? same_surface(point.xyz, n, other.xyz, point_normal(other), 1e-4 * length(point.xyz)) : 0.0;
        sum += vec4(e.rgb, 1.0) * w * exp(-min(kSpread * dot(off, off), 60.0));
    } while (++k < pixel_count);
    if (sum.a > 1e-6) imageStore(picture, p, vec4(sum.rgb / sum.a, 0.0));
}
