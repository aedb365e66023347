// The indirect light of what mirrors show.
#ifndef LANTHORN_DRM_SPECULAR_LIGHT_GLSL
#define LANTHORN_DRM_SPECULAR_LIGHT_GLSL

#include "drm_gather.glsl"

uniform int has_indirect;

vec3 indirect_irradiance(uint end, SpecularHit hit) {
    return has_indirect != 0 ? gathered_irradiance(hit.position, hit.normal) : vec3(0.0);
}

#endif
