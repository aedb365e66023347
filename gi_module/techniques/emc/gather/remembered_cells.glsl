// The point of the picture's grid that sees a start. Needs remembered.glsl.
#ifndef LANTHORN_EMC_REMEMBERED_CELLS_GLSL
#define LANTHORN_EMC_REMEMBERED_CELLS_GLSL

#include "engine/render/camera.glsl"

uniform samplerBuffer points;  // by cell
uniform usamplerBuffer keys;
uniform ivec2 grid;
uniform ivec2 image_size;
uniform int stride;

const float kLeastSame = 0.9;    // between normals of one surface, cosine
const float kThickness = 0.004;  // of a surface, of the distance it is seen from

// `off`: m, how far before its plane the place is.
bool fits(ivec2 q, vec3 x, vec3 n, float thickness, out float off) {
    off = 0.0;
    if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, grid))) return false;
    int cell = q.y * grid.x + q.x;
    vec4 point = texelFetch(points, cell);
    vec3 m = point_normal(point);
    off = dot(x - point.xyz, m);
    return texelFetch(keys, cell).r != kNoPoint && dot(n, m) > kLeastSame && abs(off) < thickness;
}

// The cell where the point is seen, or kNoPoint; and how far before the plane of what is seen there it is, in m.
uint cell_of(vec3 x, vec3 n, out float off) {
    off = 0.0;
    vec3 relative = x - camera_position;
    vec4 clip = camera_clip_from_relative * vec4(relative, 1.0);
    vec2 at = (clip.xy / max(clip.w, 1e-20) * 0.5 + 0.5) * vec2(image_size) - 0.5 - float(stride / 2);
    at /= float(stride);
    bool ahead = clip.w > 0.0 && all(greaterThan(at, vec2(-1.0))) && all(lessThan(at, vec2(grid)));
    float thickness = kThickness * camera_distance(relative);
    ivec2 nearest = ivec2(floor(at + 0.5));
    vec2 rest = at - vec2(nearest);
    ivec2 side = ivec2(rest.x < 0.0 ? -1 : 1, rest.y < 0.0 ? -1 : 1);
    uint cell = kNoPoint;
    int k = 0;
    while (k < 4 && ahead && cell == kNoPoint) {
        ivec2 q = nearest + side * ivec2(k & 1, k >> 1);
        cell = fits(q, x, n, thickness, off) ? uint(q.y * grid.x + q.x) : kNoPoint;
        ++k;
    }
    return cell;
}

#endif
