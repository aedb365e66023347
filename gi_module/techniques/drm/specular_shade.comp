#version 450 core
// Mirrors and glass with the indirect light of the direct radiance maps.
layout(local_size_x = 64) in;

#include "gi_module/shared/mirrors/specular.glsl"
#include "drm_gather.glsl"

uniform int has_indirect;

vec3 indirect_irradiance(uint end, SpecularHit hit) {
    return has_indirect != 0 ? gathered_irradiance(hit.position, hit.normal) : vec3(0.0);
}

#include "gi_module/shared/mirrors/specular_shade.glsl"
