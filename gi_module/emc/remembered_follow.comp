#version 450 core
// Which point of the picture's grid each remembered ray serves now: the one where its own start is seen, by plane and normal; if
// that does not fit, one of the three beside it. A start on something that moves is carried along. A ray whose start is seen
// nowhere is forgotten.
layout(local_size_x = 256) in;

#include "engine/render/camera.glsl"
#include "remembered.glsl"

layout(std430, binding = 1) buffer Counts { uint counts[]; };          // of starts, by cell
layout(std430, binding = 2) writeonly buffer Starts { vec4 carried_starts[]; };
layout(std430, binding = 4) writeonly buffer Texels { uint texels[]; };
layout(std430, binding = 5) writeonly buffer Flights { uint carried_flights[]; };
layout(std430, binding = 6) writeonly buffer Cells { uvec2 cells[]; };  // by start: cell, place among those of the cell

uniform usamplerBuffer remembered;  // texels
uniform samplerBuffer starts;
uniform usamplerBuffer flights;
uniform samplerBuffer points;  // by cell
uniform usamplerBuffer keys;
uniform ivec2 grid;
uniform ivec2 image_size;
uniform int stride;
#define MAX_CARRIES 16
uniform int carry_count;
uniform vec4 carry_lower[MAX_CARRIES];  // render space: where what is carried was
uniform vec4 carry_upper[MAX_CARRIES];
uniform vec4 carry_rows[3 * MAX_CARRIES];

const float kLeastSame = 0.9;    // between normals of one surface, cosine
const float kThickness = 0.004;  // of a surface, of the distance it is seen from

bool fits(ivec2 q, vec3 x, vec3 n, float thickness) {
    if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, grid))) return false;
    int cell = q.y * grid.x + q.x;
    vec4 point = texelFetch(points, cell);
    vec3 m = point_normal(point);
    return texelFetch(keys, cell).r != kNoPoint && dot(n, m) > kLeastSame && abs(dot(x - point.xyz, m)) < thickness;
}

// The cell where the point is seen, or kNoPoint.
uint cell_of(vec3 x, vec3 n) {
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
        cell = fits(q, x, n, thickness) ? uint(q.y * grid.x + q.x) : kNoPoint;
        ++k;
    }
    return cell;
}

vec3 carried(int m, vec4 v) { return vec3(dot(carry_rows[3 * m], v), dot(carry_rows[3 * m + 1], v), dot(carry_rows[3 * m + 2], v)); }

void main() {
    uint key = item_key();
    if (key >= uint(capacity)) return;
    uint slot = item_row();
    uint at = start_of(slot, key);
    uint cell = kNoPoint;
    bool is_carried = false;
    if (met(texelFetch(remembered, int(entry_of(slot, 0u, key))).r) != kNoRay) {
        vec4 start = texelFetch(starts, int(at));
        vec3 n = point_normal(start);
        cell = cell_of(start.xyz, n);
        int m = 0;
        while (m < carry_count && cell == kNoPoint) {
            if (all(greaterThan(start.xyz, carry_lower[m].xyz)) && all(lessThan(start.xyz, carry_upper[m].xyz))) {
                vec3 x = carried(m, vec4(start.xyz, 1.0));
                vec3 turned = normalize(carried(m, vec4(n, 0.0)));
                cell = cell_of(x, turned);
                if (cell != kNoPoint) {
                    is_carried = true;
                    carried_starts[at] = pack_point(x, turned);
                    for (uint j = 0u; j < uint(rays); ++j) {
                        uint entry = entry_of(slot, j, key);
                        vec3 d = unpack_direction(texelFetch(flights, int(entry)).x);
                        carried_flights[2u * entry] = pack_direction(normalize(carried(m, vec4(d, 0.0))));
                    }
                }
            }
            ++m;
        }
        if (cell == kNoPoint) {
            for (uint j = 0u; j < uint(rays); ++j) texels[entry_of(slot, j, key)] = kNoRay;
        }
    }
    uint rank = 0u;
    if (cell != kNoPoint) rank = atomicAdd(counts[cell], 1u) | (is_carried ? kCarried : 0u);
    cells[at] = uvec2(cell, rank);
}
