// What the G-buffer says of a pixel that rays of specular.glsl leave from.
#ifndef LANTHORN_MIRRORS_SPECULAR_PIXEL_GLSL
#define LANTHORN_MIRRORS_SPECULAR_PIXEL_GLSL

#include "engine/render/brdf_table.glsl"
#include "engine/render/camera.glsl"
#include "engine/render/gbuffer_flags.glsl"
#include "engine/render/ggx.glsl"
#include "engine/render/octahedral.glsl"
#include "engine/render/traced_lobes.glsl"

uniform ivec2 image_size;
uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform sampler2D gbuffer_albedo;
uniform sampler2D gbuffer_material;
uniform sampler2D gbuffer_emissive;
uniform float most_roughness;  // of surfaces whose lobes are traced
uniform int grid;              // pixels a side of a cell, of which the first has a ray

struct SpecularPixel {
    bool seen;
    vec3 position;   // render space
    vec3 towards;    // the viewer, unit
    vec3 normal;     // shading
    vec3 geometric;
    float alpha;     // GGX
    float occlusion;
    vec3 specular;   // share of even light that the lobe reflects
    float through;   // share that goes through
    float traced;    // share of the lobe that is traced
    float flags;     // gbuffer_flags.glsl
};

float lobe_alpha(float roughness) { return max(roughness * roughness, 2e-3); }

SpecularPixel specular_pixel(ivec2 p) {
    SpecularPixel s;
    float distance = texelFetch(gbuffer_distance, p, 0).r;
    vec4 material = texelFetch(gbuffer_material, p, 0);
    s.seen = distance > 0.0 && !flags_say_unlit(material.a);
    vec4 normals = texelFetch(gbuffer_normals, p, 0);
    vec4 albedo = texelFetch(gbuffer_albedo, p, 0);
    vec2 uv = (vec2(p) + 0.5) / vec2(image_size);
    s.position = render_position(uv, distance);
    s.towards = -pixel_direction(uv);
    s.normal = octahedral_decode(normals.xy);
    s.geometric = octahedral_decode(normals.zw);
    s.alpha = lobe_alpha(material.r);
    s.flags = material.a;
    s.occlusion = material.b;
    float nv = dot(s.normal, s.towards);
    vec2 share = brdf_share(nv, material.r);
    s.specular = reflectance(albedo.rgb, albedo.a, material.g, nv, share).specular;
    float dielectric = material.g * share.x + min(50.0 * material.g, 1.0) * share.y;
    s.through = texelFetch(gbuffer_emissive, p, 0).a * (1.0 - dielectric);
    s.traced = traced_share(material.r, most_roughness);
    return s;
}

bool mirrors(SpecularPixel s) {
    return s.seen && s.traced > 0.0 && max(s.specular.r, max(s.specular.g, s.specular.b)) > 1e-3;
}
bool shows_through(SpecularPixel s) { return s.seen && s.through > 1e-3; }

const float kSameNormal = 0.95;

// Whether pixel q shows the surface of p, nearly.
bool same_surface(SpecularPixel s, ivec2 q) {
    vec2 uv = (vec2(q) + 0.5) / vec2(image_size);
    vec3 there = render_position(uv, texelFetch(gbuffer_distance, q, 0).r);
    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, q, 0).xy);
    float tolerance = 0.02 * length(s.position - camera_position);
    return dot(normal, s.normal) >= kSameNormal && abs(dot(there - s.position, s.geometric)) <= tolerance;
}

const float kSameWidth = 1.3;

// Whether lobes are about as wide; those of mirrors are.
bool same_width(float a, float b) {
    return max(a, b) < kMirrorAlpha || (min(a, b) >= kMirrorAlpha && max(a, b) <= kSameWidth * min(a, b));
}

// The same, and that what is seen through q is of the same colour and as sharp.
bool same_pane(SpecularPixel s, ivec2 q) {
    vec4 material = texelFetch(gbuffer_material, q, 0);
    return material.a == s.flags && same_width(lobe_alpha(material.r), s.alpha) && same_surface(s, q);
}

#endif
