// What a light shines on at a place of its picture.
#ifndef LANTHORN_DRM_PICTURE_LOOK_GLSL
#define LANTHORN_DRM_PICTURE_LOOK_GLSL

#include "engine/render/kept_albedo.glsl"
#include "engine/render/light_map.glsl"
#include "engine/render/octahedral.glsl"
#include "light_picture.glsl"
#include "solid_angle.glsl"

layout(std430, binding = 3) readonly buffer Pictures { LightPicture pictures[]; };

uniform sampler2DArray light_distance;
uniform sampler2DArray light_normals;
uniform sampler2DArray light_albedo;
uniform sampler2DArray lamp_distance;
uniform sampler2DArray lamp_normals;
uniform sampler2DArray lamp_albedo;

struct Seen {
    vec3 offset;  // from the light's position
    float area;   // m^2, eq. 13; 0: nothing is seen
    vec3 normal;
    float across;
    vec3 flux;    // reflected, lumen
    float along;  // metres that the light has come
};

const Seen kNothingSeen = Seen(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);

// What exact rays follow light over: smooth metal, and what it goes through (gi_module/shared/rays/specular_chain.h).
bool sends_light_on(vec4 kept) {
    uint number = uint(kept.a);
    if (number == 0u) return false;
    MaterialData m = kept_materials[number - 1u];
    return (m.metallic > 0.5 && m.roughness < 0.4) || m.transmission * (1.0 - m.metallic) >= 0.5;
}

// Of which the ray is a `share` of the picture. `on`: it is sent on.
Seen look_along(uint p, PictureRay ray, float share, out bool on) {
    LightData light = lights[p];
    Seen seen = kNothingSeen;
    on = false;
    bool parallel = pictures[p].shape == kPictureParallel;
    int layer;
    vec2 at;
    if (!light_map_lookup_from_light(light, parallel ? ray.offset : ray.direction, layer, at)) return seen;
    bool here = pictures[p].drawn_here != 0u;
    ivec2 size = here ? textureSize(lamp_distance, 0).xy : textureSize(light_distance, 0).xy;
    ivec3 texel = ivec3(clamp(ivec2(at * vec2(size)), ivec2(0), size - 1), layer);
    float stored = here ? texelFetch(lamp_distance, texel, 0).r : texelFetch(light_distance, texel, 0).r;
    if (!(stored > 0.0)) return seen;
    vec2 packed_normal = here ? texelFetch(lamp_normals, texel, 0).rg : texelFetch(light_normals, texel, 0).rg;
    vec4 kept = here ? texelFetch(lamp_albedo, texel, 0) : texelFetch(light_albedo, texel, 0);
    on = sends_light_on(kept);
    seen.normal = octahedral_decode(packed_normal);
    // The distance along this very direction: the texel's plane, not its centre.
    vec3 centre_origin;
    vec3 centre_direction;
    light_map_ray(light, layer - int(light.first_layer), (vec2(texel.xy) + 0.5) / vec2(size), centre_origin, centre_direction);
    float facing = dot(seen.normal, ray.direction);
    float t = dot(seen.normal, centre_origin + centre_direction * stored - light.position - ray.offset) / min(facing, -1e-6);
    t = facing < -0.02 ? clamp(t, 0.8 * stored, 1.25 * stored) : stored;
    seen.along = t;
    seen.offset = ray.offset + ray.direction * t;
    seen.across = ray.extent * share * (parallel ? 1.0 : t * t);
    seen.area = drm_area(seen.across, -facing);
    seen.flux = ray.lumen * kept_albedo(kept) * share;
    if (!parallel) seen.flux *= light_range_window(light, t);
    return seen;
}

#endif
