#version 450 core
// Of the four points of the grid around each pixel, how much each counts: by distance, and by whether it is of the pixel's surface.
layout(local_size_x = 8, local_size_y = 8) in;

#include "point_lists.glsl"
#include "splat_surface.glsl"
#include "gather_surface.glsl"

layout(r32ui, binding = 0) uniform writeonly uimage2D fits;  // 8 bits a point, of the one that counts most; 0: none does

uniform samplerBuffer points;
uniform usamplerBuffer walls;  // by cell (gather_links.h)
uniform ivec2 grid;

const float kLeast = 0.02;  // less of them all is chance

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

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, image_size))) return;
    vec3 x;
    vec3 n;
    float d = surface_at(pixel, x, n);
    float slack = 1e-4 * d;
    vec2 at = (vec2(pixel) - float(stride / 2)) / float(stride);
    ivec2 base = ivec2(floor(at));
    vec2 f = at - vec2(base);
    bool whole = all(greaterThanEqual(base, ivec2(0)));
    bvec4 sides = same_side(whole ? texelFetch(walls, base.y * grid.x + base.x).r : 0u, f);
    vec4 weights = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        ivec2 q = base + corner;
        bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, grid));
        q = clamp(q, ivec2(0), grid - 1);
        vec4 point = texelFetch(points, q.y * grid.x + q.x);
        vec2 w = mix(1.0 - f, f, vec2(corner)) + 1e-3;
        weights[k] = inside && sides[k] ? w.x * w.y * same_surface(x, n, point.xyz, point_normal(point), slack) : 0.0;
    }
    bool fit = d > 0.0 && dot(weights, vec4(1.0)) >= kLeast;
    float most = max(max(weights.x, weights.y), max(weights.z, weights.w));
    imageStore(fits, pixel, uvec4(fit ? packUnorm4x8(weights / most) : 0u));
}
