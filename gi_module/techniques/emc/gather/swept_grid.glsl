// The cells that many movers sweep. The C++ side: swept_grid.h.
#ifndef LANTHORN_EMC_SWEPT_GRID_GLSL
#define LANTHORN_EMC_SWEPT_GRID_GLSL

uniform usamplerBuffer grid_columns;  // a bit a layer
uniform vec3 grid_lower;              // render space
uniform vec3 grid_scale;              // cells a metre
uniform int grid_up;                  // the axis of columns

const float kGridSide = 64.0;
const float kGridLayers = 32.0;
const float kGridSlack = 0.01;  // of a layer, for rounding

// Columns last.
vec3 grid_order(vec3 v) { return grid_up == 0 ? v.yzx : grid_up == 1 ? v.zxy : v; }

// Whether a mover may have come between a point and what lies `l` metres on in direction d: a walk from column to column
// (Amanatides and Woo 1987). Swept cells that the point lies in, and those right behind them, count only `if_inside`.
bool crosses_the_grid(vec3 x, vec3 d, float l, bool if_inside) {
    vec3 o = grid_order((x - grid_lower) * grid_scale);
    vec3 r = grid_order(d * grid_scale);
    vec3 inverse = 1.0 / mix(r, vec3(1e-20), lessThan(abs(r), vec3(1e-20)));
    vec3 low = -o * inverse;
    vec3 high = (vec3(kGridSide, kGridSide, kGridLayers) - o) * inverse;
    vec3 near = min(low, high);
    vec3 far = max(low, high);
    float t = max(max(near.x, near.y), max(near.z, 0.0));
    float end = min(min(far.x, far.y), min(far.z, l));
    vec2 cell = clamp(floor(o.xy + r.xy * t), vec2(0.0), vec2(kGridSide - 1.0));
    vec2 onward = mix(vec2(-1.0), vec2(1.0), greaterThanEqual(inverse.xy, vec2(0.0)));
    vec2 next = (cell + max(onward, vec2(0.0)) - o.xy) * inverse.xy;
    bool leaving = !if_inside && max(max(near.x, near.y), near.z) <= 0.0;
    bool crosses = false;
    while (t < end && !crosses) {
        float leave = min(min(next.x, next.y), end);
        vec2 heights = o.z + r.z * vec2(t, leave);
        uint first = uint(clamp(min(heights.x, heights.y) - kGridSlack, 0.0, kGridLayers - 1.0));
        uint last = uint(clamp(max(heights.x, heights.y) + kGridSlack, 0.0, kGridLayers - 1.0));
        uint bits = (0xffffffffu >> (31u - last)) & (0xffffffffu << first);
        bool swept = (texelFetch(grid_columns, int(cell.y * kGridSide + cell.x)).r & bits) != 0u;
        leaving = leaving && swept;
        crosses = swept && !leaving;
        bool first_axis = next.x < next.y;
        vec2 along = vec2(first_axis ? 1.0 : 0.0, first_axis ? 0.0 : 1.0);
        cell = clamp(cell + along * onward, vec2(0.0), vec2(kGridSide - 1.0));
        next += along * abs(inverse.xy);
        t = leave;
    }
    return crosses;
}

#endif
