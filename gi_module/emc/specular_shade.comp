#version 450 core
// The light that comes back along the rays of specular.glsl: emitted, and reflected of direct light, by the light maps, and of
// indirect light, by the lit maps; or the sky's.
layout(local_size_x = 64) in;

#include "engine/render/direct_irradiance.glsl"
#include "engine/render/camera.glsl"
#include "engine/render/sky.glsl"
#include "engine/render/traced_lobes.glsl"
#include "intersection.glsl"
#include "lit_lookup.glsl"
#include "specular.glsl"
#include "caustic_cells.glsl"
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
uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform sampler2D picture_irradiance;
uniform int has_picture;
uniform int has_caustics;

const int kSpacing = 4;  // lit texels between those that a point's mean is of: about as far as light on them is gathered

// Indirect irradiance of a lit texel, B / albedo - E0; where it is too dark to tell, its other colours'.
vec3 texel_indirect(int place) {
    vec3 albedo = texelFetch(lit_albedo, place).rgb;
    vec3 e = texelFetch(lit_radiosity, place).rgb / max(albedo, vec3(1e-3)) - texelFetch(lit_direct, place).rgb;
    vec3 tells = vec3(greaterThan(albedo, vec3(0.01)));
    float mean = dot(e, tells) / max(dot(tells, vec3(1.0)), 1.0);
    return max(mix(vec3(mean), e, tells), vec3(0.0));
}

// The mean around the point, of the lit texels on its surface: light on them is gathered by few rays, and noise is seen in a mirror.
vec3 lit_irradiance(vec3 x, vec3 d, vec3 n) {
    uint id = lit_place_of(x, d, n);
    if (id >= kListed) return vec3(0.0);
    int place = int(id);
    int face = place / (lit_resolution * lit_resolution);
    vec3 o = x - map_centres[face / 6].xyz;
    ivec2 middle = ivec2(place % lit_resolution, place / lit_resolution % lit_resolution);
    vec2 at = cube_face_uv(o).xy * float(lit_resolution) - 0.5;
    vec4 sum = vec4(0.0);
    for (int k = 0; k < 9; ++k) {
        ivec2 p = clamp(middle + kSpacing * (ivec2(k % 3, k / 3) - 1), ivec2(0), ivec2(lit_resolution - 1));
        int near = lit_place(ivec3(p, face));
        vec2 away = max(1.0 - abs(vec2(p) - at) / float(2 * kSpacing), vec2(0.0)) + 1e-3;
        vec3 m;
        bool fits = shows(near, x, o, m) && dot(m, n) > kLeastLitCosine;
        if (fits) sum += vec4(texel_indirect(near), 1.0) * (away.x * away.y);
    }
    return sum.a > 0.0 ? sum.rgb / sum.a : texel_indirect(place);
}

// Where the picture shows the point itself it knows better.
vec3 indirect_irradiance(vec3 x, vec3 d, vec3 n) {
    vec4 clip = camera_clip_from_relative * vec4(x - camera_position, 1.0);
    vec2 uv = clip.xy / max(clip.w, 1e-6) * 0.5 + 0.5;
    if (has_picture != 0 && clip.w > 0.0 && all(greaterThan(uv, vec2(0.0))) && all(lessThan(uv, vec2(1.0)))) {
        ivec2 size = textureSize(gbuffer_distance, 0);
        ivec2 p = ivec2(uv * vec2(size));
        float seen = texelFetch(gbuffer_distance, p, 0).r;
        vec3 there = render_position((vec2(p) + 0.5) / vec2(size), seen);
        vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, p, 0).zw);
        float near = 4.0 * seen / float(size.y);  // a few pixels
        bool shown = seen > 0.0 && dot(normal, n) > kLeastLitCosine && distance(there, x) < near;
        if (shown) return texelFetch(picture_irradiance, p, 0).rgb;
    }
    vec3 e = has_lit != 0 ? lit_irradiance(x, d, n) : vec3(0.0);
    return has_caustics != 0 ? e + caustics_at(x, n, 1e-5 * scene_diagonal) : e;
}

// The share of a met light's emission that the ray brings; direct light brings the rest, if it has samples of that light. Of a small
// light over mirrors and through glass the rest is missing: one ray in thousands would meet it, and sparkle.
float share_of_emission(SpecularRay ray, SpecularHit hit, float density) {
    float share = 1.0;
#ifdef WITH_AREA
    float nearest = 3e38;
    int at = punctual_count;
    for (int k = punctual_count; k < light_count; ++k) {
        vec3 off = lights[k].position - hit.position;
        bool may_be = hit.emitter == 0u || lights[k].id + 1u == hit.emitter;
        bool nearer = may_be && dot(off, off) < nearest;
        at = nearer ? k : at;
        nearest = nearer ? dot(off, off) : nearest;
    }
    // The maps do not know what they show: a lamp that has a sample nearby.
    bool sampled = hit.emitter != 0u ? nearest < 3e38 : nearest < 16.0 * lights[at].area;
    if (sampled) share = share_of_rays(density, area_solid_angle(lights[at], ray.origin));
#endif
    return share;
}

vec3 radiance_of(SpecularHit hit, SpecularRay ray, float density) {
    vec3 radiance = hit.emission;
    if (density > 0.0 && hit.emission != vec3(0.0)) radiance *= share_of_emission(ray, hit, density);
    if (hit.kind == kMetSky && has_sky != 0) radiance = hit.reflectance * sky_radiance(hit.normal);
    if (hit.kind == kMetSurface) {
        vec3 e = direct_irradiance(hit.position, hit.normal);
        e += indirect_irradiance(hit.position, -hit.normal, hit.normal);
        radiance += hit.reflectance * e * 0.31830988618;
    }
    return radiance;
}

void main() {
    uint i = work_item();
    if (i >= ray_count) return;
    uint at = 2u * rays[i].pixel + (rays[i].through & 1u);
    float density = samples[at].density;
    vec3 radiance = vec3(0.0), lobe = vec3(0.0);
    float known = 0.0;
    uint end = i;
    do {  // all ends of the ray: no next is 0
        SpecularHit hit = hits[end];
        vec3 here = radiance_of(hit, rays[i], density);
        bool spread = density < 0.0 && hit.spread > 0.0;
        radiance += spread ? vec3(0.0) : here;
        lobe += spread ? here : vec3(0.0);
        known = max(known, hit.kind == kNothingKnown ? 0.0 : hit.spread > 0.0 ? kSpread : 1.0);
        end = hit.next;
    } while (end != 0u);
    if (is_bad(radiance + lobe)) {
        atomicAdd(bad_value_count, 1u);
        radiance = lobe = vec3(0.0);
    }
    samples[at].radiance = radiance;
    if (density < 0.0) samples[at].lobe = lobe;
    samples[at].known = known;
}
