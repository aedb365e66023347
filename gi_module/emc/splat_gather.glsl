// Irradiance at a surface point from the splats that cover it (Yao et al. 2010, sec. 6), with the kernel cut to the surface.
//
// Kernel: Epanechnikov, 2 / (pi h^2) (1 - r^2 / h^2), which integrates to 1 over a disc of radius h. Where the surface ends or
// a wall stands within h, part of the disc holds no photons and a plain sum would darken (boundary bias, sec. 9.2). So each
// pixel knows in eight directions how far its surface goes on (splat_boundaries.comp); photons from beyond are passed over (no
// light leaks under walls), and the sum is divided by the kernel's mass over what is left.
#ifndef LANTHORN_EMC_SPLAT_GATHER_GLSL
#define LANTHORN_EMC_SPLAT_GATHER_GLSL

#include "splat_surface.glsl"

uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
uniform usamplerBuffer photon_lists;
uniform usampler2D boundaries;
uniform float scene_diagonal;

struct Receiver {
    vec3 x;
    vec3 normal;
    vec3 tangent;
    vec3 bitangent;
    vec4 free_low;  // squared free radii of sectors 0..3, 4..7
    vec4 free_high;
    float scale;    // of a photon of bandwidth bandwidth_max
};

struct Photon {
    vec3 position;
    vec3 normal;
    vec3 power;
    float inverse_h2;
    float thickness;  // of the layer around a surface that its splat lights
};

// 2 / (pi h^2), divided by the kernel's mass over the free part of its disc: a sector whose radius rho is at least h counts
// whole, another 2 rho^2 / h^2 - rho^4 / h^4.
float kernel_scale(vec4 free_low, vec4 free_high, float inverse_h2) {
    vec4 low = min(free_low * inverse_h2, vec4(1.0));
    vec4 high = min(free_high * inverse_h2, vec4(1.0));
    float mass = (dot(low, 2.0 - low) + dot(high, 2.0 - high)) * (1.0 / float(kSectors));
    return 2.0 / 3.14159265359 * inverse_h2 / max(mass, 0.05);
}

float inverse_square(float h) { return 1.0 / max(h * h, 1e-30); }

Receiver receiver_at(ivec2 pixel, out float d) {
    Receiver r;
    d = surface_at(pixel, r.x, r.normal);
    r.tangent = surface_tangent(r.normal);
    r.bitangent = cross(r.normal, r.tangent);
    vec4 low;
    vec4 high;
    unpack_radii(texelFetch(boundaries, pixel, 0), low, high);
    low *= bandwidth_max;
    high *= bandwidth_max;
    r.free_low = low * low;
    r.free_high = high * high;
    r.scale = kernel_scale(r.free_low, r.free_high, inverse_square(bandwidth_max));
    return r;
}

Photon photon_at(int entry) {
    int index = 2 * int(texelFetch(photon_lists, entry).r);
    vec4 place = texelFetch(photon_hits, index);     // position, radius
    vec4 load = texelFetch(photon_hits, index + 1);  // power, normal
    Photon photon;
    photon.position = place.xyz;
    photon.power = load.rgb;
    photon.normal = octahedral_decode(unpackSnorm2x16(floatBitsToUint(load.w)));
#if BANDWIDTH_FIXED
    float h = bandwidth_max;
#else
    float h = place.w;
#endif
    photon.inverse_h2 = inverse_square(h);
    photon.thickness = 0.25 * h + 1e-5 * scene_diagonal;
    return photon;
}

// What one photon adds to the receiver's irradiance.
vec3 splat(Receiver r, Photon photon) {
    vec3 d = photon.position - r.x;
    float u = dot(d, d) * photon.inverse_h2;
    // Sector of the direction in the tangent plane, by comparisons alone.
    vec2 p = vec2(dot(d, r.tangent), dot(d, r.bitangent));
    bool steep = abs(p.y) > abs(p.x);
    float right = p.y < 0.0 ? (steep ? r.free_high.z : r.free_high.w) : (steep ? r.free_low.y : r.free_low.x);
    float left = p.y < 0.0 ? (steep ? r.free_high.y : r.free_high.x) : (steep ? r.free_low.z : r.free_low.w);
    float free2 = p.x < 0.0 ? left : right;
#if BANDWIDTH_FIXED
    float scale = r.scale;
    bool near = dot(d, d) < free2;  // never more than h^2
#else
    float scale = kernel_scale(r.free_low, r.free_high, photon.inverse_h2);
    bool near = u < 1.0 && dot(d, d) < free2;
#endif
    bool inside = near && abs(dot(d, r.normal)) < photon.thickness && dot(photon.normal, r.normal) > 0.5;
    return photon.power * (inside ? (1.0 - u) * scale : 0.0);
}

#endif
