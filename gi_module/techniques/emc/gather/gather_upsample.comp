#version 450 core
// From the grid of points to pixels: between the four points around, each by distance and by whether it is of the pixel's surface.
// PLACED 0: finds out how much each of the four counts, and keeps it. PLACED 1: as it was found before. An invocation does all
// pixels between four points. Pixels that share their surface with none of them, or with such alone as know nothing, are listed for
// gather_lone.comp.
layout(local_size_x = 8, local_size_y = 8) in;

#include "point_lists.glsl"
#include "gi_module/techniques/emc/splat/splat_surface.glsl"
#include "entry_list.glsl"

layout(rgba32f, binding = 0) uniform writeonly image2D picture;

uniform samplerBuffer irradiance;  // lux; a < 0: nothing is known
uniform ivec2 grid;

#if PLACED
uniform usampler2D fits;
#else
#include "gather_surface.glsl"

layout(r32ui, binding = 1) uniform writeonly uimage2D fits;  // 8 bits a point, of the one that counts most; 0: none does

uniform samplerBuffer points;
uniform usamplerBuffer walls;  // by cell (gather_links.h)

const float kLeast = 0.02;  // less of them all is chance

vec3 corners[4];
vec3 normals[4];
bvec4 inside;

// Which of a cell's four corners lie on the same side of its walls as f, which is 0..1 between them. Walls are few: where there
// is none no loop is run through.
bvec4 same_side(uint edges, vec2 f) {
    bvec4 same = bvec4(true);
    vec2 first = vec2(0.0);
    vec2 last = vec2(0.0);
    int count = 0;
    while (edges != 0u) {
        int edge = findLSB(edges) >> 3;
        float t = float(edges >> (8 * edge) & 255u) * (1.0 / 255.0);
        edges &= ~(255u << (8 * edge));
        // Edges 0 and 1 are level, 2 and 3 upright.
        bool level = edge < 2;
        int low = level ? 2 * edge : edge - 2;
        int high = low + (level ? 1 : 2);
        bool before = (level ? f.x : f.y) <= t;
        same[low] = same[low] && before;
        same[high] = same[high] && !before;
        last = level ? vec2(t, float(edge)) : vec2(float(edge - 2), t);
        first = count == 0 ? last : first;
        ++count;
    }
    // One wall right through.
    vec2 across = vec2(first.y - last.y, last.x - first.x);
    bool side = dot(across, f - first) > 0.0;
    for (int k = 0; k < 4 && count == 2; ++k) same[k] = (dot(across, vec2(k & 1, k >> 1) - first) > 0.0) == side;
    return same;
}

uint fits_of(ivec2 pixel, vec2 f, uint edges) {
    vec3 x;
    vec3 n;
    float d = surface_at(pixel, x, n);
    float slack = 1e-4 * d;
    bvec4 sides = same_side(edges, f);
    vec4 weights = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        vec2 w = mix(1.0 - f, f, vec2(k & 1, k >> 1)) + 1e-3;
        weights[k] = inside[k] && sides[k] ? w.x * w.y * same_surface(x, n, corners[k], normals[k], slack) : 0.0;
    }
    float most = max(max(weights.x, weights.y), max(weights.z, weights.w));
    bool fit = d > 0.0 && dot(weights, vec4(1.0)) >= kLeast;
    return fit ? packUnorm4x8(weights / most) : 0u;
}
#endif

void main() {
    ivec2 base = ivec2(gl_GlobalInvocationID.xy) - 1;
    if (any(greaterThanEqual(base, grid))) return;
    vec4 known[4];
    for (int k = 0; k < 4; ++k) {
        ivec2 q = base + ivec2(k & 1, k >> 1);
        ivec2 nearest = clamp(q, ivec2(0), grid - 1);
        int at = nearest.y * grid.x + nearest.x;
        vec4 e = texelFetch(irradiance, at);
        known[k] = vec4(e.rgb, 1.0) * (e.a >= 0.0 ? 1.0 : 0.0);
#if !PLACED
        vec4 point = texelFetch(points, at);
        corners[k] = point.xyz;
        normals[k] = point_normal(point);
        inside[k] = q == nearest;
#endif
    }
#if !PLACED
    uint edges = inside[0] ? texelFetch(walls, base.y * grid.x + base.x).r : 0u;
#endif
    ivec2 first = base * stride + stride / 2;
    for (int k = 0; k < stride * ((stride + 31) / 32); ++k) {
        ivec2 run = first + ivec2(k / stride * 32, k % stride);  // of a row, 32 pixels at most
        uint lone = 0u;                                          // a bit a pixel of it
        for (int i = 0; i < min(first.x + stride - run.x, 32); ++i) {
            ivec2 pixel = run + ivec2(i, 0);
            if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, image_size))) continue;
#if PLACED
            uint bits = texelFetch(fits, pixel, 0).r;
#else
            uint bits = fits_of(pixel, vec2(pixel - first) / float(stride), edges);
            imageStore(fits, pixel, uvec4(bits));
#endif
            vec4 weights = unpackUnorm4x8(bits);
            vec4 sum = known[0] * weights.x + known[1] * weights.y + known[2] * weights.z + known[3] * weights.w;
            imageStore(picture, pixel, vec4(sum.rgb / max(sum.a, 1e-20), 0.0));
            lone |= sum.a <= 0.0 ? 1u << i : 0u;
        }
        // Such pixels are few, or background: where there is none no loop is run through.
        while (lone != 0u) {
            ivec2 pixel = run + ivec2(findLSB(lone), 0);
            lone &= lone - 1u;
            if (texelFetch(gbuffer_distance, pixel, 0).r > 0.0) list_entry(uint(pixel.y * image_size.x + pixel.x));
        }
    }
}
