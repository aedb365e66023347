#version 450 core
// Light that air scatters towards the eye along the ray of a tile of 4 x 4 pixels (air.h).
#include "camera.glsl"
#include "light_map.glsl"
#include "shining_lights.glsl"

layout(location = 0) out vec4 out_air;

uniform sampler2D gbuffer_distance;
uniform sampler2DArray light_map_distance;
uniform float scattering;  // 1/m
uniform int steps;
uniform float reach;

struct AirRay {
    vec3 from;  // render space
    vec3 along;
    float far;
    float first;  // where in its share of the ray each place lies, 0..1
};

// From where to where on the ray a spot's cone is; an empty span if nowhere.
vec2 within_cone(LightData light, AirRay ray) {
    vec2 span = vec2(0.0, ray.far);
    float c2 = light.cos_outer * light.cos_outer;
    if (light.type != kLightSpot || light.cos_outer <= 0.0) return span;
    vec3 q = ray.from - light.position;
    float dd = dot(light.direction, ray.along), dq = dot(light.direction, q);
    float a = dd * dd - c2;
    float b = dd * dq - c2 * dot(q, ray.along);
    float c = dq * dq - c2 * dot(q, q);
    float inside = b * b - a * c;
    if (inside < 0.0 || abs(a) < 1e-12) return vec2(0.0);
    float root = sqrt(inside);
    vec2 ends = (vec2(-b) + vec2(-root, root) * sign(a)) / a;  // the nearer first
    if (a > 0.0) {  // steeper than the cone: to the end that lies ahead of the light
        if (dd > 0.0) span.x = max(ends.y, 0.0);
        else span.y = min(ends.x, ray.far);
        return span;
    }
    bool ahead = dq + dd * 0.5 * (ends.x + ends.y) > 0.0;
    return ahead ? vec2(max(ends.x, 0.0), min(ends.y, ray.far)) : vec2(0.0);
}

// 1 where the light's map saw nothing before the point, 0 in its shadow.
float seen_by(LightData light, vec3 point, float distance) {
#ifdef SHARED_MAPS
    light.position += light.map_offset;
    if (light.type != kLightDirectional) distance = length(point - light.position);
#endif
    int layer;
    vec2 uv;
    if (!light_map_lookup(light, point, layer, uv)) return 1.0;
    if (light.type == kLightDirectional) distance = dot(point - light.position, light.direction);
    float stored = textureLod(light_map_distance, vec3(uv, float(layer)), 0.0).r;
    return stored > 0.0 && stored < distance ? 0.0 : 1.0;
}

// Integral of the light's illuminance along the ray, lux metres.
vec3 along_ray(LightData light, AirRay ray) {
    float sum = 0.0;
    if (light.type == kLightDirectional) {
        float width = ray.far / float(steps);
        for (int k = 0; k < steps; ++k) {
            sum += width * seen_by(light, ray.from + ray.along * (width * (float(k) + ray.first)), 0.0);
        }
        return light.intensity * sum;
    }
    vec2 span = within_cone(light, ray);
    if (span.y <= span.x) return vec3(0.0);
    float closest = dot(light.position - ray.from, ray.along);
    float height = max(length(ray.from + ray.along * closest - light.position), 1e-4);
    float begin = atan(span.x - closest, height);
    float width = (atan(span.y - closest, height) - begin) / float(steps);
    for (int k = 0; k < steps; ++k) {
        float t = closest + height * tan(begin + width * (float(k) + ray.first));
        vec3 point = ray.from + ray.along * t;
        vec3 away = point - light.position;
        float distance = length(away);
        float share = light_cone(light, away / max(distance, 1e-30)) * light_range_window(light, distance);
        sum += share * seen_by(light, point, distance);
    }
    return light.intensity * (sum * width / height);
}

void main() {
    ivec2 size = textureSize(gbuffer_distance, 0);
    ivec2 tile = ivec2(gl_FragCoord.xy);
    ivec2 pixel = min(4 * tile + 2, size - 1);
    vec2 at = (vec2(pixel) + 0.5) / vec2(size);
    float seen = texelFetch(gbuffer_distance, pixel, 0).r;
    // Four neighbours share out the places between those of one.
    float first = 0.125 + 0.25 * float(((tile.x ^ tile.y) & 1) * 2 + (tile.y & 1));
    AirRay ray = AirRay(camera_position + pixel_origin(at), pixel_direction(at), seen > 0.0 ? seen : reach, first);
    vec3 sum = vec3(0.0);
#ifdef LAMP_TREES
    LampRay target = LampRay(ray.from, ray.along, ray.far);
#endif
#define ADD_AIR(LIGHT) sum += along_ray(LIGHT, ray);
    PUNCTUAL_LIGHTS(ADD_AIR, target)
    out_air = vec4(sum * (scattering * 0.07957747155), ray.far);  // evenly to all sides: 1 / (4 pi)
}
