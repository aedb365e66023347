// Irradiance at a surface point from the splats that cover it (Yao et al. 2010, sec. 6), with the kernel cut to the surface.
//
// Kernel: Epanechnikov, 2 / (pi h^2) (1 - r^2 / h^2), which integrates to 1 over a disc of radius h. Where the surface ends or
// a wall stands within h, part of the disc holds no photons and a plain sum would darken (boundary bias, sec. 9.2). So each
// pixel looks along eight directions how far its surface goes on, as the map that sees it best shows it; photons from
// beyond are passed over (no light leaks under walls), and the sum is divided by the kernel's mass over what is left.
#ifndef LANTHORN_EMC_SPLAT_GATHER_GLSL
#define LANTHORN_EMC_SPLAT_GATHER_GLSL

#include "intersection.glsl"
#include "photon.glsl"
#include "engine/render/camera.glsl"

layout(std430, binding = 5) readonly buffer TileStarts { uint starts[]; };
uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
uniform usamplerBuffer photon_lists;

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform ivec2 image_size;
uniform ivec2 tile_grid;
uniform int tile_size;
uniform float bandwidth_max;

// Surface point of a full-size pixel; its distance, 0 for background.
float surface_at(ivec2 pixel, out vec3 position, out vec3 normal) {
    float d = texelFetch(gbuffer_distance, pixel, 0).r;
    position = render_position((vec2(pixel) + 0.5) / vec2(image_size), d);
    normal = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).zw);
    return d;
}

const int kSectors = 8;

// Whether the plane of texel value `g` passes through o (relative to the map's centre) and faces as `normal` does.
bool on_plane(vec3 g, vec3 o, vec3 normal, float tolerance) {
    float l = max(length(o), 1e-30);
    float facing = dot(g, normal) * inversesqrt(max(dot(g, g), 1e-30));
    return facing < -0.7 && abs(dot(o, g) - 1.0) * l < tolerance * max(-dot(o, normal) / l, 0.1);
}

bool on_surface(int slot, vec3 x, vec3 normal, float tolerance) {
    vec3 o = x - map_centres[slot].xyz;
    return on_plane(texelFetch(environment_planes, map_texel(slot, o), 0).xyz, o, normal, tolerance);
}

// Whether no texel around x shows a surface in front of it.
bool in_view(int slot, vec3 x, float tolerance) {
    vec3 o = x - map_centres[slot].xyz;
    vec3 f = cube_face_uv(o);
    ivec2 base = ivec2(floor(f.xy * float(map_resolution) - 0.5));
    bool hidden = false;
    for (int k = 0; k < 4; ++k) {
        ivec2 p = clamp(base + ivec2(k & 1, k >> 1), ivec2(0), ivec2(map_resolution - 1));
        vec3 g = texelFetch(environment_planes, ivec3(p, slot * 6 + int(f.z)), 0).xyz;
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
        bool usable = slot_in_use(slot, 0.0) && in_view(slot, x, tolerance);
        float fineness = usable ? max(-dot(o, normal), 1e-3 * length(o)) / max(dot(o, o), 1e-30) : -1.0;
        best = fineness > finest ? slot : best;
        finest = max(finest, fineness);
    }
    return best;
}

// Radii at which a sector is looked at: bandwidth_max * 2^(-0.75 * (kRadii - j)), j = 1..kRadii; radius 0 stands for less.
const int kRadii = 6;
const float kSmallest = 0.05;

float sector_radius(int j) { return bandwidth_max * (j == 0 ? kSmallest : exp2(-0.75 * float(kRadii - j))); }

// How far the surface goes on in one sector as the map shows it, as an index of sector_radius.
int free_radius(int slot, vec3 x, vec3 normal, vec3 direction, float tolerance) {
    int reach = 0;
    for (int j = 1; j <= kRadii; ++j) {
        float radius = sector_radius(j);
        if (!on_surface(slot, x + direction * radius, normal, tolerance + 0.15 * radius)) break;
        reach = j;
    }
    return reach;
}

vec3 gather(vec3 x, vec3 normal, ivec2 pixel) {
    vec3 t = normalize(abs(normal.x) < 0.5 ? vec3(0.0, -normal.z, normal.y) : vec3(-normal.y, normal.x, 0.0));
    vec3 b = cross(normal, t);
    float tolerance = 0.02 * bandwidth_max + 1e-4 * scene_diagonal;
    vec3 above = x + normal * (0.02 * bandwidth_max);
    int sharpest = sharpest_map(above, normal, tolerance);

    // The kernel's mass over the free part of its disc, for a bandwidth h: sectors whose radius rho is at least h count whole,
    // each other 2 rho^2 / h^2 - rho^4 / h^4. By class of h (between which sector radii it lies): (whole, sum of 2 rho^2,
    // sum of rho^4) over the sectors.
    vec4 free_low = vec4(0.0);  // squared free radii of sectors 0..3, 4..7
    vec4 free_high = vec4(0.0);
    vec3 mass[kRadii + 1];
    for (int j = 0; j <= kRadii; ++j) mass[j] = vec3(0.0);
    for (int k = 0; k < kSectors; ++k) {
        float angle = (float(k) + 0.5) * (6.28318530718 / float(kSectors));
        vec3 direction = t * cos(angle) + b * sin(angle);
        int reach = sharpest >= 0 ? free_radius(sharpest, x, normal, direction, tolerance) : 1;
        float rho = sector_radius(reach);
        // A wall that stands on the surface is met exactly by a ray just above it, where texels are too coarse to tell.
        MapHit wall = march(max(sharpest, 0), above, direction, 0.0, rho);
        // Over the sector's 45 degrees the wall comes nearer than on its middle line: by how much, its direction tells.
        vec3 across = wall.normal - normal * dot(wall.normal, normal);
        float c = clamp(-dot(across, direction) * inversesqrt(max(dot(across, across), 1e-12)), 0.0, 1.0);
        float nearest = c > 0.92388 ? 1.0 : 0.92388 * c + 0.38268 * sqrt(1.0 - c * c);
        rho = sharpest >= 0 && wall.t >= 0.0 ? min(rho, wall.t * c / nearest) : rho;
        float rho2 = rho * rho;
        vec4 place = vec4(equal(ivec4(k & 3), ivec4(0, 1, 2, 3))) * (rho2 * 1.0001);
        free_low += k < 4 ? place : vec4(0.0);
        free_high += k < 4 ? vec4(0.0) : place;
        for (int j = 0; j <= kRadii; ++j) {
            mass[j] += sector_radius(j) <= rho ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 2.0 * rho2, rho2 * rho2);
        }
    }
#if BANDWIDTH_FIXED
    vec3 m = mass[kRadii];
#endif

    ivec2 tile_xy = pixel / tile_size;
    int tile = tile_xy.y * tile_grid.x + tile_xy.x;
    int last = int(starts[tile + 1]);
    vec3 sum = vec3(0.0);
    for (int e = int(starts[tile]); e < last; ++e) {
        int index = 2 * int(texelFetch(photon_lists, e).r);
        vec4 place = texelFetch(photon_hits, index);     // position, radius
        vec4 load = texelFetch(photon_hits, index + 1);  // power, normal
        vec3 d = place.xyz - x;
        float r2 = dot(d, d);
        float inverse_h2 = 1.0 / max(place.w * place.w, 1e-30);
        // Sector of the direction in the tangent plane, by comparisons alone.
        vec2 p = vec2(dot(d, t), dot(d, b));
        bool steep = abs(p.y) > abs(p.x);
        float right = p.y < 0.0 ? (steep ? free_high.z : free_high.w) : (steep ? free_low.y : free_low.x);
        float left = p.y < 0.0 ? (steep ? free_high.y : free_high.x) : (steep ? free_low.z : free_low.w);
        float free2 = p.x < 0.0 ? left : right;
#if !BANDWIDTH_FIXED
        // Class of h: the first sector radius that is not below it.
        vec3 m = mass[0];
        for (int j = 1; j <= kRadii; ++j) m = place.w > sector_radius(j - 1) * 1.001 ? mass[j] : m;
#endif
        float kernel_mass = max((m.x + (m.y - m.z * inverse_h2) * inverse_h2) * (1.0 / float(kSectors)), 0.05);
        vec2 o = unpackSnorm2x16(floatBitsToUint(load.w));
        vec3 n = vec3(o, 1.0 - abs(o.x) - abs(o.y));
        float fold = max(-n.z, 0.0);
        n.xy -= vec2(n.x >= 0.0 ? fold : -fold, n.y >= 0.0 ? fold : -fold);
        float facing = dot(n, normal);
        bool inside = r2 * inverse_h2 < 1.0 && abs(dot(d, normal)) < 0.25 * place.w + 1e-5 * scene_diagonal && r2 < free2 &&
                      facing > 0.0 && facing * facing > 0.25 * dot(n, n);
        float weight = (1.0 - r2 * inverse_h2) * inverse_h2 / kernel_mass;
        sum += load.rgb * (inside ? weight : 0.0);
    }
    return sum * (2.0 / 3.14159265359);
}

#endif
