// How much of a light reaches a point, by its map.
#ifndef LANTHORN_SHADOW_GLSL
#define LANTHORN_SHADOW_GLSL
#include "light_map.glsl"

uniform sampler2DArray light_map_distance;
uniform sampler2DArray area_map_distance;

// 1 where the map saw nothing nearer than `distance`.
vec4 shadow_lit(vec4 stored, float distance) {
    return vec4(1.0) - vec4(greaterThan(stored, vec4(0.0))) * vec4(lessThan(stored, vec4(distance)));
}

// Bilinear over 2x2 texels.
float shadow_2x2(sampler2DArray map, vec2 uv, float layer, float distance) {
    vec2 size = vec2(textureSize(map, 0).xy);
    vec2 t = uv * size - 0.5;
    vec2 f = fract(t);
    vec4 lit = shadow_lit(textureGather(map, vec3((floor(t) + 1.0) / size, layer)), distance);
    return mix(mix(lit.w, lit.z, f.x), mix(lit.x, lit.y, f.x), f.y);
}

// Mean of 3x3 bilinear taps, from 4x4 texels in four gathers.
float shadow_3x3(sampler2DArray map, vec2 uv, float layer, float distance) {
    vec2 size = vec2(textureSize(map, 0).xy);
    vec2 t = uv * size - 0.5;
    vec2 base = floor(t);
    vec2 f = t - base;
    vec4 wx = vec4(1.0 - f.x, 1.0, 1.0, f.x);
    vec4 wy = vec4(1.0 - f.y, 1.0, 1.0, f.y);
    float sum = 0.0;
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            vec2 corner = (base + vec2(2.0 * i, 2.0 * j)) / size;
            vec4 lit = shadow_lit(textureGather(map, vec3(corner, layer)), distance);
            vec2 x = i == 0 ? wx.xy : wx.zw;
            vec2 y = j == 0 ? wy.xy : wy.zw;
            sum += (lit.w * x.x + lit.z * x.y) * y.x + (lit.x * x.x + lit.y * x.y) * y.y;
        }
    }
    return sum / 9.0;
}

// 0..1 for a surface at `point` with unit geometric normal `normal`. The point is lifted off its surface by what
// the filter's texels can differ in depth on the surface's own plane: in texels, so at every scale alike.
float light_visibility(LightData light, vec3 point, vec3 normal, vec3 to_light, float distance) {
    if (light.layers == 0u) return 1.0;
    bool area = light.type == kLightAreaSample;
    float cosine = clamp(dot(normal, to_light), 0.0, 1.0);
    float sine = sqrt(1.0 - cosine * cosine);
    float texel = light.type == kLightDirectional ? light.texel : light.texel * distance;
    vec3 lifted = point + normal * (texel * ((area ? 1.5 : 3.0) * sine + 0.02));
    int layer;
    vec2 uv;
    if (!light_map_lookup(light, lifted, layer, uv)) return 1.0;
    vec3 q = light.position - lifted;
    float lifted_distance = light.type == kLightDirectional ? dot(q, -light.direction) : length(q);
    return area ? shadow_2x2(area_map_distance, uv, float(layer), lifted_distance)
                : shadow_3x3(light_map_distance, uv, float(layer), lifted_distance);
}

#endif
