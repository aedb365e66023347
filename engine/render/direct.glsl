// Direct light of all light sources at one point of a surface.
#ifndef LANTHORN_DIRECT_GLSL
#define LANTHORN_DIRECT_GLSL
#include "brdf.glsl"
#include "ggx.glsl"
#include "shadow.glsl"
#include "shining_lights.glsl"
#include "traced_lobes.glsl"

// What is known of the point.
struct LitSurface {
    vec3 point;  // render space
    vec3 v;      // unit, towards the viewer
    vec3 shading;  // unit normals, on the side of v
    vec3 geometric;
    vec3 base;
    float metallic;
    float roughness;
    float f0;
};

float lit_cosine(LitSurface s, vec3 l) {
    return dot(s.geometric, l) > 0.0 ? max(dot(s.shading, l), 0.0) : 0.0;
}

vec3 lit_radiance(LitSurface s, vec3 l, vec3 illuminance, float weight, float lobe) {
    vec3 brdf = metallic_roughness_brdf(s.base, s.metallic, s.roughness, s.f0, s.shading, s.v, l, lobe);
    return weight > 0.0 ? illuminance * brdf * weight : vec3(0.0);
}

// Radiance of one light, nits.
vec3 punctual_radiance(LightData light, LitSurface s) {
    vec3 l;
    float distance;
    vec3 illuminance = punctual_illuminance(light, s.point, l, distance);
    float weight = lit_cosine(s, l) * punctual_visibility(light, s.point, s.geometric, l, distance);
    return lit_radiance(s, l, illuminance, weight, 1.0);
}

// `traced`: see direct_radiance().
vec3 area_radiance(LightData light, LitSurface s, float traced) {
    vec3 l;
    float distance;
    vec3 illuminance = area_illuminance(light, s.point, l, distance);
    float weight = lit_cosine(s, l) * area_visibility(light, s.point, s.geometric, l, distance);
    float a = max(s.roughness * s.roughness, 2e-3);
    float by_rays = share_of_rays(lobe_density(s.shading, s.v, l, a), area_solid_angle(light, s.point));
    return lit_radiance(s, l, illuminance, weight, 1.0 - traced * by_rays);
}

// Radiance towards s.v, nits. `traced`: share of the specular lobe that rays follow, which bring area lights, too (share_of_rays()).
vec3 direct_radiance(LitSurface s, float traced) {
    vec3 sum = vec3(0.0);
#ifdef LAMP_TREES
    float a = max(s.roughness * s.roughness, 2e-3);
    LampTarget target = LampTarget(s.point, s.geometric, s.shading, s.v, a * a);
#endif
#define ADD_PUNCTUAL(LIGHT) sum += punctual_radiance(LIGHT, s);
#define ADD_AREA(LIGHT) sum += area_radiance(LIGHT, s, traced);
    PUNCTUAL_LIGHTS(ADD_PUNCTUAL, target)
    AREA_LIGHTS(ADD_AREA)
    return sum;
}

#endif
