// Direct light of all light sources at one point of a surface.
#ifndef LANTHORN_DIRECT_GLSL
#define LANTHORN_DIRECT_GLSL
#include "brdf.glsl"
#include "ggx.glsl"
#include "near_emitters.glsl"
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

// Of what area lights send, the share that no rays bring. `traced`: see direct_radiance().
float share_of_samples(LightData light, LitSurface s, vec3 l, float traced) {
    float a = max(s.roughness * s.roughness, 2e-3);
    return 1.0 - traced * share_of_rays(lobe_density(s.shading, s.v, l, a), area_solid_angle(light, s.point));
}

// As far as it is not near.
vec3 area_radiance(LightData light, float nearness, LitSurface s, float traced) {
    vec3 l;
    float distance;
    vec3 illuminance = area_illuminance(light, s.point, l, distance);
    float weight = (1.0 - nearness) * lit_cosine(s, l) * area_visibility(light, s.point, s.geometric, l, distance);
    return lit_radiance(s, l, illuminance, weight, share_of_samples(light, s, l, traced));
}

// As far as it is near: what is mirrored of it as wide as it is (Karis 2013).
vec3 near_radiance(LightData light, float nearness, LitSurface s, float traced) {
    vec3 l;
    float distance;
    area_illuminance(light, s.point, l, distance);
    float weight = nearness * area_visibility(light, s.point, s.geometric, l, distance);
    float lobe = share_of_samples(light, s, l, traced);
    NearLight near = near_light(light, nearness, s.point, s.geometric, s.shading);
    s.roughness = sqrt(min(s.roughness * s.roughness + sqrt(length(near.flow)) / 3.0, 1.0));
    return lit_radiance(s, unit_or_zero(near.flow), near.irradiance, weight, lobe);
}

// Of all area samples.
vec3 area_radiances(LitSurface s, float traced) {
    vec3 sum = vec3(0.0);
#ifdef WITH_AREA
    int near = light_end;
#define ADD_AREA(LIGHT)                                             \
    {                                                               \
        LightData light = LIGHT;                                    \
        float nearness = emitter_nearness(light, s.point);          \
        sum += area_radiance(light, nearness, s, traced);           \
        near = near == light_end && nearness > 0.0 ? i : near;      \
    }
    AREA_LIGHTS(ADD_AREA)
    do {
        LightData light = light_of_kind(min(near, light_end - 1), kLightAreaSample, 6u);
        float nearness = near < light_end ? emitter_nearness(light, s.point) : 0.0;
        sum += near_radiance(light, nearness, s, traced);
        near = next_near_emitter(near + 1, s.point);
    } while (near < light_end);
#endif
    return sum;
}

// Radiance towards s.v, nits. `traced`: share of the specular lobe that rays follow, which bring area lights, too (share_of_rays()).
vec3 direct_radiance(LitSurface s, float traced) {
    vec3 sum = vec3(0.0);
#ifdef LAMP_TREES
    float a = max(s.roughness * s.roughness, 2e-3);
    LampTarget target = LampTarget(s.point, s.geometric, s.shading, s.v, a * a);
#endif
#define ADD_PUNCTUAL(LIGHT) sum += punctual_radiance(LIGHT, s);
    PUNCTUAL_LIGHTS(ADD_PUNCTUAL, target)
    return sum + area_radiances(s, traced);
}

#endif
