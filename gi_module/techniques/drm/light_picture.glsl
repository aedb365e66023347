// From a place in a light's picture to the ray that it shows.
#ifndef LANTHORN_DRM_LIGHT_PICTURE_GLSL
#define LANTHORN_DRM_LIGHT_PICTURE_GLSL

#include "engine/render/lights.glsl"
#include "radiance_sample.h"

struct PictureRay {
    vec3 offset;     // of its start from the light, metres: 0 but in parallel light
    vec3 direction;  // unit
    float extent;    // of the whole picture at this place's density: steradians, in parallel light square metres
    vec3 lumen;      // of the whole picture at this place's brightness
};

// The unit square onto the unit disc, areas in proportion (Shirley and Chiu 1997).
vec2 square_to_disc(vec2 uv) {
    vec2 p = uv * 2.0 - 1.0;
    bool wide = abs(p.x) > abs(p.y);
    float r = wide ? p.x : p.y;
    float share = (wide ? p.y : p.x) / (abs(r) > 1e-12 ? r : 1.0);
    float angle = 0.78539816340 * share;
    return r * (wide ? vec2(cos(angle), sin(angle)) : vec2(sin(angle), cos(angle)));
}

// The unit square onto the unit sphere, areas in proportion: an octahedron unfolded (Clarberg 2008).
vec3 square_to_sphere(vec2 uv) {
    vec2 p = uv * 2.0 - 1.0;
    float d = 1.0 - (abs(p.x) + abs(p.y));
    float r = 1.0 - abs(d);
    float angle = 0.78539816340 * (r > 1e-12 ? (abs(p.y) - abs(p.x)) / r + 1.0 : 1.0);
    float across = r * sqrt(max(2.0 - r * r, 0.0));
    return vec3(sign(p.x) * cos(angle) * across, sign(p.y) * sin(angle) * across, (d >= 0.0 ? 1.0 : -1.0) * (1.0 - r * r));
}

PictureRay picture_ray(LightPicture picture, LightData light, vec2 uv) {
    PictureRay ray;
    ray.offset = vec3(0.0);
    if (picture.shape == kPictureParallel) {
        vec2 at = mix(picture.window.xy, picture.window.zw, uv);
        vec2 size = picture.window.zw - picture.window.xy;
        ray.offset = light.right * at.x + light.up * at.y;
        ray.direction = light.direction;
        ray.extent = size.x * size.y;
        ray.lumen = light.intensity * ray.extent;
    } else if (picture.shape == kPictureSphere) {
        ray.direction = square_to_sphere(uv);
        ray.extent = 12.56637061436;
        ray.lumen = light.intensity * (ray.extent * light_cone(light, ray.direction));
    } else {
        vec2 disc = square_to_disc(uv);
        float r2 = min(dot(disc, disc), 1.0);
        bool cone = picture.shape == kPictureCone;
        float cosine = cone ? mix(1.0, light.cos_outer, r2) : sqrt(max(1.0 - r2, 1e-4));
        float across = sqrt(max(1.0 - cosine * cosine, 0.0)) * inversesqrt(max(r2, 1e-20));
        ray.direction = normalize(light.direction * cosine + (light.right * disc.x + light.up * disc.y) * across);
        ray.extent = cone ? 6.28318530718 * (1.0 - light.cos_outer) : 3.14159265359 / cosine;
        ray.lumen = light.intensity * (cone ? ray.extent * light_cone(light, ray.direction) : 3.14159265359 * light.area);
    }
    return ray;
}

#endif
