// The light that surfaces and sky send back along the rays of specular.glsl, an invocation for each of their ends: reflected of direct
// light, by the light maps, and of indirect light, by the technique that includes this. It has defined before
//   vec3 indirect_irradiance(uint end, SpecularHit hit)
// lux on the surface that was met there, `end` being the hit's number. specular_collect.comp adds what is emitted, and adds up.
#ifndef LANTHORN_MIRRORS_SPECULAR_SHADE_GLSL
#define LANTHORN_MIRRORS_SPECULAR_SHADE_GLSL

#include "engine/render/direct_irradiance.glsl"
#include "engine/render/sky.glsl"
#include "engine/gpu/work_items.glsl"
#include "specular.glsl"

layout(std430, binding = 0) readonly buffer Header { uint ray_count; uint ray_groups[3]; };
layout(std430, binding = 3) readonly buffer Hits { SpecularHit hits[]; };
layout(std430, binding = 5) writeonly buffer Reflected { vec4 reflected[]; };  // by hit, rgb in nits

#ifdef LAMPS_MAY_BE_KNOWN
uniform int lamps_are_known;  // 1: indirect_irradiance() has direct light in it
#else
const int lamps_are_known = 0;
#endif
uniform int hit_count;  // < 0: one a ray
uniform int has_sky;

void main() {
    uint i = work_item();
    if (i >= (hit_count < 0 ? ray_count : uint(hit_count))) return;
    SpecularHit hit = hits[i];
    vec3 radiance = vec3(0.0);
    if (hit.kind == kMetSky && has_sky != 0) radiance = hit.reflectance * sky_radiance(hit.normal);
    if (hit.kind == kMetSurface) {
        vec3 e = indirect_irradiance(i, hit);
        if (lamps_are_known == 0) e += direct_irradiance(hit.position, hit.normal);
        radiance = hit.reflectance * e * 0.31830988618;
    }
    reflected[i] = vec4(radiance, 0.0);
}

#endif
