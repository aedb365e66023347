#version 450 core
// Pixels around lamps in the picture that the points of the grid do not serve: smaller things than its cells, beside a lamp, where
// light is another on each of them. `squares` of `side` pixels each, one a lamp.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gi_module/techniques/emc/splat/splat_surface.glsl"
#include "gather_surface.glsl"
#include "entry_list.glsl"

uniform samplerBuffer squares;  // xy: the first pixel; z: the lamp's number
uniform samplerBuffer lamps;    // xyz
uniform samplerBuffer points;   // of the grid
uniform int square_count;
uniform int side;
uniform ivec2 grid;
uniform float reach;  // m at 1 m from the camera: how near the lamp is

const float kServed = 0.6;  // share of the points around that lie on the pixel's surface

void main() {
    int item = int(work_item());
    if (item >= square_count * side * side) return;
    vec4 square = texelFetch(squares, item / (side * side));
    ivec2 pixel = ivec2(square.xy) + ivec2(item % side, item / side % side);
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, image_size))) return;
    vec3 x;
    vec3 n;
    float d = surface_at(pixel, x, n);
    bool near = d > 0.0 && distance(x, texelFetch(lamps, int(square.z)).xyz) < reach * camera_distance(x - camera_position);
    vec2 at = (vec2(pixel) - float(stride / 2)) / float(stride);
    ivec2 base = ivec2(floor(at));
    vec2 f = at - vec2(base);
    float served = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 q = clamp(base + ivec2(k & 1, k >> 1), ivec2(0), grid - 1);
        vec4 point = texelFetch(points, q.y * grid.x + q.x);
        vec2 w = mix(1.0 - f, f, vec2(k & 1, k >> 1));
        served += w.x * w.y * same_surface(x, n, point.xyz, point_normal(point), 1e-4 * d);
    }
    if (near && served < kServed) list_entry(uint(pixel.y * image_size.x + pixel.x));
}
