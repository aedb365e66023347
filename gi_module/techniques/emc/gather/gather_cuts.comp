#version 450 core
// The links of the filter that a wall stands in, a level at a time. FIRST 1: those to the eight points around, by the walls
// between neighbours. FIRST 0: twice as far as on the level before, by way of the point between; where that is of another surface
// nothing is known, and no link is cut. Walls are few: what has none near runs through no loop.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gather_surface.glsl"
#include "gather_links.glsl"

layout(std430, binding = 4) writeonly buffer Cuts { uint cuts[]; };
#if FIRST
layout(std430, binding = 5) writeonly buffer Walls { uint walls[]; };  // on the edges of cells (gather_links.h)
#endif

uniform samplerBuffer points;
uniform usamplerBuffer crossings;
uniform usamplerBuffer before;
uniform ivec2 grid;
uniform int level;

int index_of(ivec2 p) {
    p = clamp(p, ivec2(0), grid - 1);
    return p.y * grid.x + p.x;
}

bool on_surface(vec4 point, vec4 other) {
    return same_surface(point.xyz, point_normal(point), other.xyz, point_normal(other), 1e-4 * length(point.xyz)) > kSomeSurface;
}

#if FIRST

// Between p and its neighbour in direction d, along an axis.
bool wall(ivec2 p, ivec2 d) {
    ivec2 from = p + min(d, ivec2(0));
    return all(greaterThanEqual(from, ivec2(0))) && (texelFetch(crossings, index_of(from)).r >> (d.x != 0 ? 0 : 8) & 255u) != 0u;
}

uint cuts_at(ivec2 p, int i) {
    uint near = 0u;
    for (int k = 0; k < 9; ++k) near |= texelFetch(crossings, index_of(p + ivec2(k % 3 - 1, k / 3 - 1))).r;
    uint own = texelFetch(crossings, i).r;
    uint above = texelFetch(crossings, index_of(p + ivec2(0, 1))).r;
    uint right = texelFetch(crossings, index_of(p + ivec2(1, 0))).r;
    walls[i] = (own & 255u) | (above & 255u) << 8 | (own >> 8) << 16 | (right >> 8) << 24;
    vec4 point = texelFetch(points, i);
    uint found = 0u;
    for (int k = 0; k < 9 && near != 0u; ++k) {
        ivec2 dx = ivec2(k % 3 - 1, 0);
        ivec2 dy = ivec2(0, k / 3 - 1);
        // Round a wall's end one of the two ways to a point across is open.
        bool by_x = dy.y == 0 || on_surface(point, texelFetch(points, index_of(p + dx)));
        bool by_y = dx.x == 0 || on_surface(point, texelFetch(points, index_of(p + dy)));
        bool x_closed = (dx.x != 0 && wall(p, dx)) || (dy.y != 0 && wall(p + dx, dy));
        bool y_closed = (dy.y != 0 && wall(p, dy)) || (dx.x != 0 && wall(p + dy, dx));
        bool cut = (by_x || by_y) && (x_closed || !by_x) && (y_closed || !by_y);
        found |= cut ? link_bit(0, k) : 0u;
    }
    return found;
}

#else

uint cuts_at(ivec2 p, int i) {
    uint found = texelFetch(before, i).r;
    int half_way = 1 << (level - 1);
    uint closed = 0u;
    for (int k = 0; k < 9; ++k) {
        uint beyond = texelFetch(before, index_of(p + half_way * ivec2(k % 3 - 1, k / 3 - 1))).r;
        closed |= is_cut(found | beyond, level - 1, k) ? 1u << k : 0u;
    }
    vec4 point = texelFetch(points, i);
    while (closed != 0u) {
        int k = findLSB(closed);
        closed &= closed - 1u;
        bool known = on_surface(point, texelFetch(points, index_of(p + half_way * ivec2(k % 3 - 1, k / 3 - 1))));
        found |= known ? link_bit(level, k) : 0u;
    }
    return found;
}

#endif

void main() {
    int i = int(work_item());
    if (i >= grid.x * grid.y) return;
    cuts[i] = cuts_at(ivec2(i % grid.x, i / grid.x), i);
}
