// The lights of the scene (LightMaps::lights) and how bright they are.
#ifndef LANTHORN_LIGHTS_GLSL
#define LANTHORN_LIGHTS_GLSL
#include "engine/render/include/lanthorn/render/light_data.h"

#ifdef UNIFORM_LIGHTS  // all lights fit into a uniform block, which is read much faster
layout(std140, binding = 2) uniform Lights {
    LightData lights[kMaxUniformLights];
};
#else
layout(std430, binding = 2) readonly buffer Lights {
    LightData lights[];
};
#endif

// Light `i` of an array that is read as texels (RGBA32UI), word by word.
LightData light_in_texels(usamplerBuffer texels, int i) {
    int t = kLightTexels * i;
    uvec4 t0 = texelFetch(texels, t), t1 = texelFetch(texels, t + 1), t2 = texelFetch(texels, t + 2), t3 = texelFetch(texels, t + 3);
    uvec4 t4 = texelFetch(texels, t + 4), t5 = texelFetch(texels, t + 5), t6 = texelFetch(texels, t + 6), t7 = texelFetch(texels, t + 7);
    vec4 right = uintBitsToFloat(t3), up = uintBitsToFloat(t4), frustum = uintBitsToFloat(t5), texel = uintBitsToFloat(t6);
    return LightData(uintBitsToFloat(t0.xyz), uintBitsToFloat(t0.w), uintBitsToFloat(t1.xyz), t1.w, uintBitsToFloat(t2.xyz),
                     uintBitsToFloat(t2.w), right.xyz, right.w, up.xyz, up.w, frustum.x, frustum.y, t5.z, t5.w, t6.x, texel.y, texel.z,
                     t6.w, uintBitsToFloat(t7.xyz), t7.w);
}

// KHR_lights_punctual's window: 1 near the light, 0 from `range` on.
float light_range_window(LightData light, float distance) {
    if (light.range >= 1e30) return 1.0;
    float s = distance / light.range;
    s *= s;
    return clamp(1.0 - s * s, 0.0, 1.0);
}

// A spot's angular attenuation towards unit `direction` (away from the light); 1 for other lights.
float light_cone(LightData light, vec3 direction) {
    if (light.type != kLightSpot) return 1.0;
    float a = clamp(dot(direction, light.direction) * light.cone_scale + light.cone_offset, 0.0, 1.0);
    return a * a;
}

// Illuminance at `point` (render space) on a surface square to the light, in lux, without shadow; `to_light` is the
// unit direction to the light and `distance` what its map stores for the point. For point, spot and directional lights.
vec3 punctual_illuminance(LightData light, vec3 point, out vec3 to_light, out float distance) {
    vec3 offset = light.position - point;
    if (light.type == kLightDirectional) {
        to_light = -light.direction;
        distance = dot(offset, to_light);
        return light.intensity;
    }
    float r2 = dot(offset, offset);
    distance = sqrt(r2);
    to_light = offset / max(distance, 1e-30);
    return light.intensity * (light_cone(light, -to_light) * light_range_window(light, distance) / max(r2, 1e-30));
}

// The same for area samples: a disc of the sample's area, so that it stays bounded as the distance goes to 0.
vec3 area_illuminance(LightData light, vec3 point, out vec3 to_light, out float distance) {
    vec3 offset = light.position - point;
    float r2 = dot(offset, offset);
    distance = sqrt(r2);
    to_light = offset / max(distance, 1e-30);
    float cosine = -dot(to_light, light.direction);
    cosine = light.two_sided != 0u ? abs(cosine) : max(cosine, 0.0);
    return light.intensity * (light.area * cosine / max(r2 + light.area * 0.31830988618, 1e-30));
}

// Steradians of that disc, as seen from the point.
float area_solid_angle(LightData light, vec3 point) {
    vec3 offset = light.position - point;
    float r2 = dot(offset, offset);
    float cosine = abs(dot(offset, light.direction)) * inversesqrt(max(r2, 1e-30));
    return light.area * cosine / max(r2 + light.area * 0.31830988618, 1e-30);
}

// Illuminance by any light.
vec3 light_illuminance(LightData light, vec3 point, out vec3 to_light, out float distance) {
    if (light.type == kLightAreaSample) return area_illuminance(light, point, to_light, distance);
    return punctual_illuminance(light, point, to_light, distance);
}

#endif
