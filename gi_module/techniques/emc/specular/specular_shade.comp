#version 450 core
// Mirrors and glass with the indirect light of the picture and of the lit maps.
layout(local_size_x = 64) in;

#include "engine/render/camera.glsl"
#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "gi_module/techniques/emc/lit_maps/lit_lookup.glsl"
#include "gi_module/shared/mirrors/specular.glsl"
#include "gi_module/techniques/emc/caustics/caustic_cells.glsl"

// By place.
uniform samplerBuffer lit_radiosity;
uniform samplerBuffer lit_albedo;
uniform samplerBuffer lit_direct;
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
vec3 indirect_irradiance(uint end, SpecularHit hit) {
    vec3 x = hit.position, n = hit.normal;
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
    vec3 e = has_lit != 0 ? lit_irradiance(x, -n, n) : vec3(0.0);
    return has_caustics != 0 ? e + caustics_at(x, n, 1e-5 * local_length) : e;
}

#include "gi_module/shared/mirrors/specular_shade.glsl"
