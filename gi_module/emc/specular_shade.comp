#version 450 core
// The light that comes back along the rays of specular.glsl: emitted, and reflected of direct light, by the light maps, and of
// indirect light, by the lit maps; or the sky's.
layout(local_size_x = 64) in;

#include "engine/render/direct_irradiance.glsl"
#include "engine/render/sky.glsl"
#include "intersection.glsl"
#include "lit_lookup.glsl"
#include "specular.glsl"
#define BAD_VALUES_BINDING 7
#include "bad_values.glsl"

layout(std430, binding = 0) readonly buffer Header { uint ray_count; uint ray_groups[3]; };
layout(std430, binding = 1) readonly buffer Rays { SpecularRay rays[]; };
layout(std430, binding = 5) buffer Samples { SpecularSample samples[]; };
layout(std430, binding = 3) readonly buffer Hits { SpecularHit hits[]; };

// By place.
uniform samplerBuffer lit_radiosity;
uniform samplerBuffer lit_albedo;
uniform samplerBuffer lit_direct;
uniform int has_sky;
uniform int has_lit;  // 0: there are no lit maps

// Indirect irradiance of a lit texel, B / albedo - E0; where it is too dark to tell, its other colours'.
vec3 texel_indirect(int place) {
    vec3 albedo = texelFetch(lit_albedo, place).rgb;
    vec3 e = texelFetch(lit_radiosity, place).rgb / max(albedo, vec3(1e-3)) - texelFetch(lit_direct, place).rgb;
    vec3 tells = vec3(greaterThan(albedo, vec3(0.01)));
    float mean = dot(e, tells) / max(dot(tells, vec3(1.0)), 1.0);
    return max(mix(vec3(mean), e, tells), vec3(0.0));
}

// Interpolated between the four lit texels around the point, of those on its surface.
vec3 indirect_irradiance(vec3 x, vec3 d, vec3 n) {
    uint id = lit_place_of(x, d, n);
    if (id >= kListed) return vec3(0.0);
    int place = int(id);
    int face = place / (lit_resolution * lit_resolution);
    vec3 o = x - map_centres[face / 6].xyz;
    vec3 f = cube_face_uv(o);
    vec2 at = f.xy * float(lit_resolution) - 0.5;
    ivec2 base = ivec2(floor(at));
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        ivec2 p = clamp(base + corner, ivec2(0), ivec2(lit_resolution - 1));
        int near = lit_place(ivec3(p, face));
        vec2 w = mix(1.0 - (at - vec2(base)), at - vec2(base), vec2(corner)) + 1e-3;
        vec3 m;
        bool fits = int(f.z) == face % 6 && shows(near, x, o, m) && dot(m, n) > kLeastLitCosine;
        if (fits) sum += vec4(texel_indirect(near), 1.0) * (w.x * w.y);
    }
    return sum.a > 0.0 ? sum.rgb / sum.a : texel_indirect(place);
}

void main() {
    uint i = work_item();
    if (i >= ray_count) return;
    SpecularHit hit = hits[i];
    uint at = 2u * rays[i].pixel + rays[i].through;
    vec3 radiance = hit.emission;
    if (hit.kind == kMetSky && has_sky != 0) radiance = hit.reflectance * sky_radiance(hit.normal);
    if (hit.kind == kMetSurface) {
        vec3 e = direct_irradiance(hit.position, hit.normal);
        if (has_lit != 0) e += indirect_irradiance(hit.position, -hit.normal, hit.normal);
        radiance += hit.reflectance * e * 0.31830988618;
    }
    if (is_bad(radiance)) {
        atomicAdd(bad_value_count, 1u);
        radiance = vec3(0.0);
    }
    samples[at].radiance = radiance;
    samples[at].known = hit.kind == kNothingKnown ? 0.0 : 1.0;
}
