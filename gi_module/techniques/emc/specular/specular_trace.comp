#version 450 core
// The rays of specular.glsl through the environment maps. What is transparent is as thin as a sheet to them.
layout(local_size_x = 64) in;

#include "gi_module/techniques/emc/maps/intersection.glsl"
#include "gi_module/techniques/emc/lit_maps/lit_lookup.glsl"
#include "engine/render/random.glsl"
#include "gi_module/techniques/emc/photons/scatter.glsl"
#include "gi_module/shared/mirrors/specular.glsl"

layout(std430, binding = 0) readonly buffer Header { uint ray_count; uint ray_groups[3]; };
layout(std430, binding = 1) readonly buffer Rays { SpecularRay rays[]; };
layout(std430, binding = 3) writeonly buffer Hits { SpecularHit hits[]; };

// The base colour of what the maps show at x, without its texture.
vec3 tint_at(vec3 x) {
    for (int s = 0; s < map_count; ++s) {
        vec3 o = x - map_centres[s].xyz;
        ivec3 texel = map_texel(s, o);
        float off = abs(dot(o, plane_at(texel)) - 1.0);  // of its plane, in shares of the distance
        uint number = uint(texelFetch(environment_albedo, texel, 0).a);
        if (off < 0.01 && number > 0u && kept_materials[number - 1u].transmission > 0.0) return kept_materials[number - 1u].base_colour.rgb;
    }
    return vec3(1.0);
}

// Curved surfaces are planes texel by texel to the maps: nearer than some texels a ray would meet its own.
float least_distance(vec3 x) {
    float nearest = local_length;
    for (int s = 0; s < map_count; ++s) nearest = min(nearest, length(x - map_centres[s].xyz));
    return max(3.0 * nearest / float(map_resolution), ray_start());
}

void main() {
    uint i = work_item();
    if (i >= ray_count) return;
    SpecularRay ray = rays[i];
    SceneHit met = intersect_all(ray.origin, vec3(0.0), ray.direction, least_distance(ray.origin), 0, 0.0);
    SpecularHit hit;
    hit.position = met.position;
    hit.kind = met.found ? kMetSurface : kMetSky;
    hit.normal = met.found ? met.normal : ray.direction;
    hit.reflectance = met.found ? met.albedo : vec3(1.0);
    hit.emission = vec3(0.0);
    hit.spread = 0.0;
    hit.emitter = hit.next = 0u;
    if (met.found) {
        vec3 o = met.position - map_centres[met.slot].xyz;
        uint number = uint(texelFetch(environment_albedo, map_texel(met.slot, o), 0).a);
        if (number > 0u) {
            MaterialData m = kept_materials[number - 1u];
            // What a mirror reflects is no part of its albedo.
            hit.reflectance += m.base_colour.rgb * (m.metallic * (1.0 - m.reflects.z));
            hit.emission = (m.flags & kMaterialEmits) != 0u ? m.emissive.rgb : vec3(0.0);
        }
    }
    if ((ray.through & 1u) != 0u) {
        vec3 tint = tint_at(ray.origin);
        hit.reflectance *= tint;
        hit.emission *= tint;
    }
    hits[i] = hit;
}
