#version 450 core
// The rectangle of screen tiles that each photon's splat may touch: what lies within its radius is seen inside of the
// picture of a sphere.
layout(local_size_x = 64) in;

#include "engine/render/camera.glsl"
#define PHOTON_COUNT_BINDING 6
#include "gi_module/techniques/emc/photons/photon_count.glsl"
#include "splat_rects.glsl"

uniform float least_radius;  // of photons, as they are sorted
uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
layout(std430, binding = 7) writeonly buffer Rects { uint rects[]; };
uniform ivec2 image_size;
uniform ivec2 tile_grid;
uniform int tile_size;

// Where the picture of the sphere begins and ends along an axis of the image, -1 to 1 from edge to edge. `p`: its centre
// relative to the camera, not behind it.
vec2 extent(vec3 p, float h, vec3 axis) {
    float edge = length(axis);
    float x = dot(p, axis) / edge;
    if (camera_orthographic != 0) return vec2(x - h, x + h) / edge;
    float z = dot(p, camera_forward);
    if (z < 1.001 * h) return vec2(-1e6, 1e6);
    // Lines from the camera that touch the circle of radius h around (x, z).
    float square = z * z - h * h;
    float root = h * sqrt(x * x + square);
    return (x * z + vec2(-root, root)) / (square * edge);
}

// First and last tile, along an axis of the image; a pixel and a thousandth more than needed.
ivec2 tiles(vec2 range, int pixels, int last) {
    vec2 at = (range * 0.5 + 0.5) * float(pixels);
    float margin = 1.0 + 1e-3 * (at.y - at.x);
    ivec2 tile = ivec2(floor(clamp(vec2(at.x - margin, at.y + margin), vec2(-1e6), vec2(1e6)) / float(tile_size)));
    return ivec2(max(tile.x, 0), min(tile.y, last));
}

void main() {
    int i = int(gl_GlobalInvocationID.x);
    if (i >= int(photon_set_count)) return;
    vec4 place = texelFetch(photon_hits, 2 * i);  // position, radius; 0: no photon
    place.w = place.w > 0.0 ? max(place.w, least_radius) : 0.0;
    vec3 p = place.xyz - camera_position;
    ivec2 x = tiles(extent(p, place.w, camera_right), image_size.x, tile_grid.x - 1);
    ivec2 y = tiles(extent(p, place.w, camera_up), image_size.y, tile_grid.y - 1);
    bool behind = camera_orthographic == 0 && dot(p, camera_forward) < -place.w;
    bool none = place.w <= 0.0 || behind || x.y < x.x || y.y < y.x;
    uint rect = any(greaterThan(tile_grid, ivec2(kLastTile + 1))) ? kAllTiles : pack_rect(ivec2(x.x, y.x), ivec2(x.y, y.y));
    rects[i] = none ? kNoTiles : rect;
}
