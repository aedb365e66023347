#version 450 core
// How far the surface of a pixel goes on in eight directions, at most kReach * bandwidth_max: where it ends or a wall stands on
// it, as the map that sees it best shows it; and the weights
// that make the kernel a fair one over the polygon that these corners span. Depends on surfaces, maps and camera, not on light: a pixel's radii are found when
// it is first gathered, and hold until one of those changes.
#if LISTED
layout(local_size_x = 64) in;
#else
layout(local_size_x = 8, local_size_y = 8) in;
#endif

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "splat_surface.glsl"
#include "kernel_moments.glsl"

layout(rgba32ui, binding = 0) uniform writeonly uimage2D boundaries;
layout(rgba32f, binding = 1) uniform writeonly image2DArray weights;
#if LISTED
#include "splat_lists.glsl"
layout(std430, binding = 4) readonly buffer NewPixels { uint new_pixels[]; };
#else
uniform ivec2 level_size;
#endif

// Whether no texel around x shows a surface in front of it.
bool in_view(int slot, vec3 x, float tolerance) {
    vec3 o = x - map_centres[slot].xyz;
    vec3 f = cube_face_uv(o);
    ivec2 base = ivec2(floor(f.xy * float(map_resolution) - 0.5));
    bool hidden = false;
    for (int k = 0; k < 4; ++k) {
        ivec2 p = clamp(base + ivec2(k & 1, k >> 1), ivec2(0), ivec2(map_resolution - 1));
        vec3 g = plane_at(ivec3(p, slot * 6 + int(f.z)));
        hidden = hidden || (dot(o, g) - 1.0) * length(o) > 2.0 * tolerance;
    }
    return !hidden;
}

// Of the maps that see the point x just above its surface, the one whose texels are smallest there; -1: none.
int sharpest_map(vec3 x, vec3 normal, float tolerance) {
    int best = -1;
    float finest = 0.0;
    for (int slot = 0; slot < map_count; ++slot) {
        vec3 o = x - map_centres[slot].xyz;
        bool usable = slot_in_use(slot, 0.0) && in_view(slot, x, tolerance) && !sheet_hides(slot, o, normal);
        float fineness = usable ? max(-dot(o, normal), 1e-3 * length(o)) / max(dot(o, o), 1e-30) : -1.0;
        best = fineness > finest ? slot : best;
        finest = max(finest, fineness);
    }
    return best;
}

// Radii that a direction is looked at: kReach * bandwidth_max * 2^(-0.75 * (kRadii - j)), j = 1..kRadii; radius 0 stands for
// less.
const int kRadii = 6;
const float kSmallest = 0.05;

float corner_radius(int j) { return kReach * bandwidth_max * (j == 0 ? kSmallest : exp2(-0.75 * float(kRadii - j))); }

// How far the surface goes on in one direction as the map shows it, measured in the tangent plane. Walks along the surface, so
// that round ones are followed too: a chord of a round surface is square to the mean of the normals at its ends.
float free_radius(int slot, vec3 x, vec3 normal, vec3 direction, float tolerance) {
    vec3 start = x - map_centres[slot].xyz;  // all places are relative to the map's centre
    vec3 place = start;
    vec3 ahead = direction;
    float walked = 0.0;
    float reach = corner_radius(0);
    for (int j = 1; j <= kRadii; ++j) {
        float radius = corner_radius(j);
        float slack = tolerance + 0.15 * radius;
        vec3 look = place + ahead * (radius - walked);
        vec3 g = plane_at(map_texel(slot, look));
        vec3 there = -g * inversesqrt(max(dot(g, g), 1e-30));
        vec3 found = look / max(dot(look, g), 1e-3);  // where the map sees the surface in that direction
        float off_chord = 0.5 * dot(there + normal, found - start);
        float off_plane = (dot(look, g) - 1.0) * max(-dot(look, there), 0.1 * length(look));
        float turn = dot(there, normal);
        if (!(turn > kLeastTurn && abs(off_chord) < slack && abs(off_plane) < slack)) break;
        reach = radius * (2.0 + turn) / 3.0;  // an arc's projection: sin(a) / a is nearly (2 + cos(a)) / 3
        walked = radius;
        place = found;
        ahead = normalize(direction - there * dot(direction, there));  // never 0: its length is kLeastTurn at least
    }
    return reach;
}

void main() {
#if LISTED
    uint place = row_index(gl_WorkGroupID) * 64u + gl_LocalInvocationID.x;
    if (place >= new_count) return;
    uint entry = new_pixels[place];
    ivec2 pixel = full_size_pixel(ivec2(int(entry & 0xffffu), int(entry >> 16u)));
#else
    if (any(greaterThanEqual(ivec2(gl_GlobalInvocationID.xy), level_size))) return;
    ivec2 pixel = full_size_pixel(ivec2(gl_GlobalInvocationID.xy));
#endif
    vec3 x;
    vec3 normal;
    surface_at(pixel, x, normal);
    vec3 t = surface_tangent(normal);
    vec3 b = cross(normal, t);
    float tolerance = 0.02 * bandwidth_max + 1e-4 * local_length;
    vec3 above = x + normal * (0.02 * bandwidth_max);
    int sharpest = sharpest_map(above, normal, tolerance);
    vec4 low = vec4(0.0);  // corners 0..3, 4..7
    vec4 high = vec4(0.0);
    Moments m = Moments(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    float before = 0.0;
    for (int k = 0; k < kCorners; ++k) {
        float angle = float(k) * (6.28318530718 / float(kCorners));
        vec3 direction = t * cos(angle) + b * sin(angle);
        float rho = sharpest >= 0 ? free_radius(sharpest, x, normal, direction, tolerance) : corner_radius(1);
        // A wall that stands on the surface is met exactly by a ray just above it, where texels are too coarse to tell.
        MapHit wall = march(max(sharpest, 0), above, direction, 0.0, rho);
        rho = sharpest >= 0 && wall.t >= 0.0 ? min(rho, wall.t) : rho;
        rho = max(rho / (kReach * bandwidth_max), 1e-3);
        if (k > 0) add_triangle(m, angle - 0.78539816, before * kReach, rho * kReach);
        before = rho;
        vec4 place = vec4(equal(ivec4(k & 3), ivec4(0, 1, 2, 3))) * rho;
        low += k < 4 ? place : vec4(0.0);
        high += k < 4 ? vec4(0.0) : place;
    }
    add_triangle(m, -0.78539816, before * kReach, low.x * kReach);
    imageStore(boundaries, pixel, pack_radii(low, high));
    LinearWeights w = linear_weights(m);
    imageStore(weights, ivec3(pixel, 0), w.constant);
    imageStore(weights, ivec3(pixel, 1), w.slope_x);
    imageStore(weights, ivec3(pixel, 2), w.slope_y);
}
