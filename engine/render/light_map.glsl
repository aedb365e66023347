// Where a point falls in a light's map, and back.
#ifndef LANTHORN_LIGHT_MAP_GLSL
#define LANTHORN_LIGHT_MAP_GLSL
#include "cube.glsl"
#include "lights.glsl"

// Layer and uv (0..1) in the light's map of the point `q` from the light's position; false outside of a frustum or orthographic
// map, or without a map. For cubes and frusta `q` may be any multiple of a direction.
bool light_map_lookup_from_light(LightData light, vec3 q, out int layer, out vec2 uv) {
    layer = int(light.first_layer);
    uv = vec2(0.5);
    if (light.layers == 0u) return false;
    if (light.layers == 6u) {
        vec3 face_uv = cube_face_uv(q);
        uv = face_uv.xy;
        layer += int(face_uv.z);
        return true;
    }
    float w = light.extent;
    if (light.type != kLightDirectional) {
        float z = dot(q, light.direction);
        if (z <= 0.0) return false;
        w *= z;
    }
    uv = vec2(dot(q, light.right), dot(q, light.up)) * (0.5 / w) + 0.5;
    return all(greaterThanEqual(uv, vec2(0.0))) && all(lessThanEqual(uv, vec2(1.0)));
}

// The same of render-space `point`.
bool light_map_lookup(LightData light, vec3 point, out int layer, out vec2 uv) {
    return light_map_lookup_from_light(light, point - light.position, layer, uv);
}

// The ray of `uv` in the light's map (`face` = layer - first_layer): origin in render space and unit direction;
// the surface seen is at origin + direction * stored distance.
void light_map_ray(LightData light, int face, vec2 uv, out vec3 origin, out vec3 direction) {
    vec2 p = uv * 2.0 - 1.0;
    origin = light.position + light.map_offset;
    if (light.type == kLightDirectional) {
        origin += (light.right * p.x + light.up * p.y) * light.extent;
        direction = light.direction;
    } else if (light.layers == 6u) {
        direction = normalize(cube_direction(face, uv));
    } else {
        direction = normalize(light.direction + (light.right * p.x + light.up * p.y) * light.extent);
    }
}

// Clip position of render-space `point` on layer `face` of the light's map; depth reversed.
vec4 light_map_clip(LightData light, int face, vec3 point, float near) {
    vec3 q = point - light.position;
    if (light.layers == 6u) return cube_clip(face, q, near);
    vec2 p = vec2(dot(q, light.right), dot(q, light.up)) / light.extent;
    float z = dot(q, light.direction);
    if (light.type == kLightDirectional) return vec4(p, 1.0 - z / light.depth_range, 1.0);
    return vec4(p, near, z);
}

#endif
