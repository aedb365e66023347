// Irradiance at a surface point from the splats that cover it (Yao et al. 2010, sec. 6), with the kernel cut to the surface.
//
// Kernel: Epanechnikov, 2 / (pi h^2) (1 - r^2 / h^2), which integrates to 1 over a disc of radius h. Where the surface ends or
// a wall stands within h, part of the disc holds no photons and a plain sum would darken (boundary bias, sec. 9.2). So each
// pixel knows the polygon that its surface fills around it (splat_boundaries.comp); photons from beyond are passed over (no
// light leaks under walls), and the kernel is weighted so that it is a fair one over the polygon (kernel_moments.glsl).
#ifndef LANTHORN_EMC_SPLAT_GATHER_GLSL
#define LANTHORN_EMC_SPLAT_GATHER_GLSL

#include "splat_surface.glsl"
#include "splat_tiles.glsl"

uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
uniform usampler2D boundaries;
uniform sampler2DArray weights;
uniform float local_length;

struct Receiver {
    vec3 x;
    vec3 normal;
    vec3 tangent;
    vec3 bitangent;
    // Edges of the polygon, in units of bandwidth_max: what has dot(p, edge) > 1 lies beyond. Edges 0..3, 4..7.
    vec4 edge_x_low;
    vec4 edge_y_low;
    vec4 edge_x_high;
    vec4 edge_y_high;
    // The kernel is multiplied by weight.x + dot(p, weight.yz), at kNodes.
    vec4 constant;
    vec4 slope_x;
    vec4 slope_y;
};

struct Photon {
    vec3 position;
    vec3 normal;
    vec3 power;
    float inverse_h2;
    vec4 node_weights;
    float thickness;  // of the layer around a surface that its splat lights
};

float inverse_square(float h) { return 1.0 / max(h * h, 1e-30); }

Receiver receiver_at(ivec2 pixel, out float d) {
    Receiver r;
    d = surface_at(pixel, r.x, r.normal);
    r.tangent = surface_tangent(r.normal) / bandwidth_max;
    r.bitangent = cross(r.normal, r.tangent);
    vec4 low;
    vec4 high;
    unpack_radii(texelFetch(boundaries, pixel, 0), low, high);
    // The line through corners a and b, at angles k * 45 degrees: dot(a, edge) = dot(b, edge) = 1.
    const vec4 kCosLow = vec4(1.0, 0.70710678, 0.0, -0.70710678);
    const vec4 kSinLow = vec4(0.0, 0.70710678, 1.0, 0.70710678);
    vec4 inverse_low = 1.0 / (kReach * max(low, vec4(1e-3)));
    vec4 inverse_high = 1.0 / (kReach * max(high, vec4(1e-3)));
    vec4 next_low = vec4(inverse_low.yzw, inverse_high.x);
    vec4 next_high = vec4(inverse_high.yzw, inverse_low.x);
    vec4 next_cos = vec4(kCosLow.yzw, -kCosLow.x);
    vec4 next_sin = vec4(kSinLow.yzw, -kSinLow.x);
    const float kInverseSin = 1.41421356;  // of the angle between corners
    r.edge_x_low = (inverse_low * next_sin - next_low * kSinLow) * kInverseSin;
    r.edge_y_low = (next_low * kCosLow - inverse_low * next_cos) * kInverseSin;
    r.edge_x_high = (next_high * kSinLow - inverse_high * next_sin) * kInverseSin;
    r.edge_y_high = (inverse_high * next_cos - next_high * kCosLow) * kInverseSin;
    r.constant = texelFetch(weights, ivec3(pixel, 0), 0);
    r.slope_x = texelFetch(weights, ivec3(pixel, 1), 0);
    r.slope_y = texelFetch(weights, ivec3(pixel, 2), 0);
    return r;
}

// `load`: power, normal; h: bandwidth.
Photon photon_with(vec3 position, vec4 load, float h) {
    Photon photon;
    photon.position = position;
    photon.power = load.rgb;
    photon.normal = octahedral_decode(unpackSnorm2x16(floatBitsToUint(load.w)));
    photon.inverse_h2 = inverse_square(h);
    photon.node_weights = node_weights(bandwidth_max * bandwidth_max * photon.inverse_h2);
    photon.thickness = 0.25 * h + 1e-5 * local_length;
    return photon;
}

Photon photon_at(int photon_index) {
    int index = 2 * photon_index;
    vec4 place = texelFetch(photon_hits, index);  // position, radius
#if BANDWIDTH_FIXED
    float h = bandwidth_max;
#else
    float h = place.w;
#endif
    return photon_with(place.xyz, texelFetch(photon_hits, index + 1), h);
}

// What one photon adds to the receiver's irradiance.
vec3 splat(Receiver r, Photon photon) {
    vec3 d = photon.position - r.x;
    float u = dot(d, d) * photon.inverse_h2;
    // The edge that the photon's direction points at, by comparisons alone.
    vec2 p = vec2(dot(d, r.tangent), dot(d, r.bitangent));
    bool steep = abs(p.y) > abs(p.x);
    bool below = p.y < 0.0;
    vec4 ex = below ? r.edge_x_high : r.edge_x_low;
    vec4 ey = below ? r.edge_y_high : r.edge_y_low;
    bool first_half = (p.x < 0.0) == below;
    bool second = steep == first_half;
    vec2 edge = first_half ? (second ? vec2(ex.y, ey.y) : vec2(ex.x, ey.x)) : (second ? vec2(ex.w, ey.w) : vec2(ex.z, ey.z));
    bool near = u < 1.0 && dot(p, edge) < 1.0;
    // A chord of a round surface is square to the mean of the normals at its ends; of a plane, to both.
    float turn = dot(photon.normal, r.normal);
    bool inside = near && abs(0.5 * dot(d, r.normal + photon.normal)) < photon.thickness && turn > kLeastTurn;
    float weight = dot(r.constant + p.x * r.slope_x + p.y * r.slope_y, photon.node_weights);
    float scale = 2.0 / 3.14159265359 * photon.inverse_h2 * weight;
    // Where the surface has turned, more of it lies behind the same piece of the tangent plane: by 1 / turn.
    return photon.power * (inside ? (1.0 - u) * scale * turn : 0.0);
}

#endif
