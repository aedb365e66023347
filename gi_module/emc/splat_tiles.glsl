// Photons sorted into screen tiles, so that each pixel meets only the photons whose splats may touch its tile.
// The lists keep the photons' order (no atomics), so sums are the same in every run.
#ifndef LANTHORN_EMC_SPLAT_TILES_GLSL
#define LANTHORN_EMC_SPLAT_TILES_GLSL

#include "photon.glsl"
#include "engine/render/camera.glsl"

uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
uniform samplerBuffer tile_boxes;   // two texels a tile: lower, upper; empty if lower > upper

uniform int hit_count;
uniform int chunk_count;   // photons are cut into runs of chunk_size, one invocation each
uniform int chunk_size;
uniform ivec2 tile_grid;
uniform ivec2 image_size;
uniform int tile_size;     // pixels a side

// Pixels that the sphere's projection lies in (lower xy, upper zw), never too small; everything if it reaches the viewer.
vec4 project_sphere(vec3 centre, float radius) {
    vec3 q = centre - camera_position;
    vec2 scale = vec2(dot(camera_right, camera_right), dot(camera_up, camera_up));
    vec2 p = vec2(dot(q, camera_right), dot(q, camera_up)) / scale;
    vec2 r = radius * inversesqrt(scale);
    vec2 lower = p - r;
    vec2 upper = p + r;
    if (camera_orthographic == 0) {
        float z = dot(q, camera_forward);
        float z_near = z - radius;
        float z_far = z + radius;
        if (z_far <= 0.0) return vec4(0.0, 0.0, -1.0, -1.0) * vec2(image_size).xyxy;
        if (z_near <= 1e-3 * radius) return vec4(0.0, 0.0, vec2(image_size));
        lower = vec2(lower.x < 0.0 ? lower.x / z_near : lower.x / z_far, lower.y < 0.0 ? lower.y / z_near : lower.y / z_far);
        upper = vec2(upper.x < 0.0 ? upper.x / z_far : upper.x / z_near, upper.y < 0.0 ? upper.y / z_far : upper.y / z_near);
    }
    return (vec4(lower, upper) * 0.5 + 0.5) * vec2(image_size).xyxy;
}

// The range of tiles that a sphere may touch, from its projection; all tiles if it reaches behind the viewer.
ivec4 tile_range(vec3 centre, float radius) {
    vec4 box = project_sphere(centre, radius);  // pixels: lower xy, upper zw
    // Clamped before the conversion: far outside, an int would overflow.
    vec2 grid = vec2(tile_grid);
    ivec2 lower = ivec2(clamp(floor(box.xy / float(tile_size)), vec2(0.0), grid));
    ivec2 upper = ivec2(clamp(floor(box.zw / float(tile_size)) + 1.0, vec2(0.0), grid));
    return ivec4(lower, upper);
}

bool touches(int tile, vec3 centre, float radius) {
    vec3 lower = texelFetch(tile_boxes, 2 * tile).xyz;
    vec3 upper = texelFetch(tile_boxes, 2 * tile + 1).xyz;
    vec3 d = max(max(lower - centre, centre - upper), vec3(0.0));
    return lower.x <= upper.x && dot(d, d) < radius * radius;
}

#endif
