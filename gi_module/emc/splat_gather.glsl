// Irradiance at a surface point from the splats that cover it (Yao et al. 2010, sec. 6), with the kernel cut to the surface.
//
// Kernel: Epanechnikov, 2 / (pi h^2) (1 - r^2 / h^2), which integrates to 1 over a disc of radius h. Where the surface ends or
// a wall stands within h, part of the disc holds no photons and a plain sum would darken (boundary bias, sec. 9.2). So each
// pixel looks along eight directions how far its surface goes on, as the maps that see the pixel show it; photons from
// beyond are passed over (no light leaks under walls), and the sum is divided by the kernel's mass over what is left.
#ifndef LANTHORN_EMC_SPLAT_GATHER_GLSL
#define LANTHORN_EMC_SPLAT_GATHER_GLSL

#include "intersection.glsl"
#include "photon.glsl"
#include "engine/render/camera.glsl"

layout(std430, binding = 1) readonly buffer Hits { PhotonHit hits[]; };
layout(std430, binding = 4) readonly buffer Lists { uint lists[]; };
layout(std430, binding = 5) readonly buffer TileStarts { uint starts[]; };

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform ivec2 image_size;
uniform ivec2 tile_grid;
uniform int tile_size;
uniform float bandwidth_max;

// Surface point of a full-size pixel; w of the position is 0 for background.
void surface_at(ivec2 pixel, out vec3 position, out vec3 normal, out bool valid) {
    float d = texelFetch(gbuffer_distance, pixel, 0).r;
    valid = d > 0.0;
    position = render_position((vec2(pixel) + 0.5) / vec2(image_size), d);
    normal = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).zw);
}

const int kSectors = 8;

// How well a map's texel shows the point: |1 - |x - c| / distance of the texel's plane|, and the plane's normal.
bool on_surface(int slot, vec3 x, vec3 normal, float tolerance) {
    vec3 o = x - map_centres[slot].xyz;
    vec3 g = texelFetch(environment_planes, map_texel(slot, o), 0).xyz;
    float facing = dot(g, normal) * inversesqrt(max(dot(g, g), 1e-30));
    return facing < -0.7 && abs(dot(o, g) - 1.0) * length(o) < tolerance * max(-dot(o, normal) / max(length(o), 1e-30), 0.1);
}

uvec2 maps_that_see(vec3 x, vec3 normal, float tolerance) {
    uvec2 mask = uvec2(0u);
    for (int slot = 0; slot < map_count; ++slot) {
        uint bit = on_surface(slot, x, normal, tolerance) ? 1u << uint(slot & 31) : 0u;
        if (slot < 32) mask.x |= bit;
        else mask.y |= bit;
    }
    return mask;
}

// Integral of the kernel over a disc of radius s * h, s in 0..1.
float kernel_mass(float s) {
    float s2 = s * s;
    return s2 * (2.0 - s2);
}

vec3 gather(vec3 x, vec3 normal, ivec2 pixel) {
    vec3 t = normalize(abs(normal.x) < 0.5 ? vec3(0.0, -normal.z, normal.y) : vec3(-normal.y, normal.x, 0.0));
    vec3 b = cross(normal, t);
    float tolerance = 0.02 * bandwidth_max + 1e-4 * scene_diagonal;
    uvec2 seen = maps_that_see(x, normal, tolerance);
    bool any_map = (seen.x | seen.y) != 0u;

    // Free radius by sector, and the kernel's mass for bandwidths of 1/8, 1/4, 1/2 and 1 of the largest.
    float free2[kSectors];
    vec4 mass = vec4(0.0);
    for (int k = 0; k < kSectors; ++k) {
        float angle = (float(k) + 0.5) * (6.28318530718 / float(kSectors));
        vec3 direction = t * cos(angle) + b * sin(angle);
        float reach = 0.0;
        for (int step = 1; step <= 6; ++step) {
            float radius = bandwidth_max * exp2(float(step - 6) * 0.75);  // 0.074, 0.125, 0.21, 0.35, 0.59, 1
            bool on = false;
            for (int slot = 0; slot < map_count && !on; ++slot) {
                bool usable = ((slot < 32 ? seen.x : seen.y) & (1u << uint(slot & 31))) != 0u;
                on = usable && on_surface(slot, x + direction * radius, normal, tolerance + 0.1 * radius);
            }
            if (!on) break;
            reach = radius;
        }
        reach = any_map ? max(reach, 0.05 * bandwidth_max) : bandwidth_max;
        free2[k] = reach * reach * 1.0001;
        vec4 s = min(vec4(reach / bandwidth_max) * vec4(8.0, 4.0, 2.0, 1.0), vec4(1.0));
        mass += s * s * (2.0 - s * s) * (1.0 / float(kSectors));
    }
    mass = 1.0 / max(mass, vec4(0.05));

    ivec2 tile_xy = pixel / tile_size;
    int tile = tile_xy.y * tile_grid.x + tile_xy.x;
    uint last = starts[tile + 1];
    vec3 sum = vec3(0.0);
    for (uint e = starts[tile]; e < last; ++e) {
        PhotonHit photon = hits[lists[e]];
        vec3 d = photon.position - x;
        float r2 = dot(d, d);
        float h2 = photon.radius * photon.radius;
        float height = abs(dot(d, normal));
        vec2 p = vec2(dot(d, t), dot(d, b));
        // Sector of the direction, without a trigonometric function.
        int sector = (p.y < 0.0 ? 4 : 0) + ((p.x < 0.0) != (p.y < 0.0) ? 2 : 0);
        bool past = ((p.x < 0.0) != (p.y < 0.0)) ? abs(p.y) < abs(p.x) : abs(p.y) > abs(p.x);
        sector += past ? 1 : 0;
        bool inside = r2 < h2 && height < 0.25 * photon.radius + 1e-5 * scene_diagonal && r2 < free2[sector] &&
                      dot(unpack_normal(photon.normal), normal) > 0.5;
        float level = clamp(log2(photon.radius / bandwidth_max) + 3.0, 0.0, 3.0);  // 0: 1/8 of the largest bandwidth
        float inverse_mass = level < 1.0 ? mix(mass.x, mass.y, level) : level < 2.0 ? mix(mass.y, mass.z, level - 1.0)
                                                                                     : mix(mass.z, mass.w, level - 2.0);
        float weight = (1.0 - r2 / h2) / h2 * inverse_mass;
        sum += inside ? photon.power * weight : vec3(0.0);
    }
    return sum * (2.0 / 3.14159265359);
}

#endif
