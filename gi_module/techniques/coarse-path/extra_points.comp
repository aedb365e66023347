#version 450 core
// The light of the extra points: they stand where the lattice lacks their surface, so each is averaged with the other extra points
// about it that do lie on it, by their samples, and with what the lattice knows further off.
layout(local_size_x = 64) in;

#include "gi_module/shared/coarse_grid/coarse_surface.glsl"

uniform samplerBuffer points;     // SurfacePoint
uniform samplerBuffer estimates;  // PointEstimate
uniform sampler2D light;
uniform usampler2D extras;
uniform ivec2 cells;
uniform int spacing;
uniform int extra_count;
uniform int reach;  // pixels
layout(rgba32f, binding = 0) uniform writeonly image2D irradiance;

Surface point_at(int i) {
    vec4 where = texelFetch(points, 2 * i);
    return Surface(where.xyz - camera_position, where.w, texelFetch(points, 2 * i + 1).xyz);
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= extra_count) return;
    int lattice = cells.x * cells.y;
    Surface s = point_at(lattice + i);
    uint word = floatBitsToUint(texelFetch(points, 2 * (lattice + i) + 1).w);
    ivec2 pixel = ivec2(word & 0xffffu, word >> 16u);
    vec4 sum = vec4(0.0);
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            ivec2 q = pixel + ivec2(x, y);
            if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, image_size))) continue;
            uint extra = texelFetch(extras, q, 0).r;
            if (extra == 0u) continue;
            int j = lattice + int(extra) - 1;
            if (!same_surface(s, point_at(j))) continue;
            sum += texelFetch(estimates, 2 * j + 1).x * vec4(texelFetch(estimates, 2 * j).rgb, 1.0);
        }
    }
    ivec2 cell = pixel / spacing;
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            ivec2 q = cell + ivec2(x, y);
            if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, cells))) continue;
            int j = q.y * cells.x + q.x;
            if (!same_surface(s, point_at(j))) continue;
            sum += texelFetch(estimates, 2 * j + 1).x * vec4(texelFetch(light, q, 0).rgb, 1.0);
        }
    }
    imageStore(irradiance, pixel, vec4(sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0), 0.0));
}
