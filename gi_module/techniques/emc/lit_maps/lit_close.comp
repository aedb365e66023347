#version 450 core
// What the listed close hits reflect: direct light of each by the light maps, and of the rest what their lit texel does. A hit
// without one has its own albedo, where that is known, and its rest is left to who reads it; or the colour that a light's map shows there.
layout(local_size_x = 256) in;

#include "engine/render/direct_irradiance.glsl"
#include "engine/render/kept_albedo.glsl"
#include "lit_points.glsl"
#include "lit_hits.glsl"
#define BAD_VALUES_BINDING 1
#include "gi_module/shared/bad_values.glsl"

layout(std430, binding = 3) buffer Radiosity { vec4 radiosity[]; };  // by place
layout(std430, binding = 5) readonly buffer First { vec4 first[]; };  // by place
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform samplerBuffer close_points;
uniform usamplerBuffer close_owners;
uniform samplerBuffer lit_albedo;
uniform sampler2DArray light_map_albedo;
uniform vec4 map_centres[40];  // kMaxMaps
uniform int close_first;
uniform int close_fresh;  // 1: found in this frame, and so what their texels show

// What the light's map shows at the point; 0 where it shows something else or nothing.
vec3 colour_of(LightData light, vec3 point) {
#ifdef SHARED_MAPS
    light.position += light.map_offset;
#endif
    int layer;
    vec2 uv;
    bool inside = light_map_lookup(light, point, layer, uv);
    ivec2 size = textureSize(light_map_albedo, 0).xy;
    vec4 texel = texelFetch(light_map_albedo, ivec3(clamp(ivec2(uv * vec2(size)), ivec2(0), size - 1), max(layer, 0)), 0);
    return inside ? kept_albedo(texel) : vec3(0.0);
}

// Whether the lit texel still shows the hit's surface.
bool still_shows(uint texel, vec3 x, vec3 n) {
    int place = texel < kNoRay ? int(texel) : 0;
    vec4 point = texelFetch(lit_points, place);
    float tolerance = 0.5 * distance(x, map_centres[place / (6 * lit_resolution * lit_resolution)].xyz) / float(lit_resolution);
    return texel < kNoRay && is_lit(point) && dot(point_normal(point), n) > 0.9 && abs(dot(x - point.xyz, point_normal(point))) < tolerance;
}

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    int slot = int(list[item]);
    vec4 hit = texelFetch(close_points, slot);
    vec3 x = hit.xyz;
    vec3 n = point_normal(hit);
    uint texel = texelFetch(close_owners, slot).y;
    bool has_albedo = is_close_albedo(texel);
    bool shown = close_fresh != 0 ? texel < kNoRay : still_shows(texel, x, n);
    int place = shown ? int(texel) : 0;
    vec3 own = has_albedo ? unpackUnorm4x8(texel).rgb : texelFetch(lit_albedo, place).rgb;
    bool has_colour = shown || has_albedo;
    vec3 sum = vec3(0.0);
#ifdef LAMP_TREES
    LampTarget target = matte_target(x, n);
#endif
#define ADD_COLOURED(LIGHT) { LightData light = LIGHT; sum += punctual_irradiance(light, x, n) * (has_colour ? own : colour_of(light, x)); }
    PUNCTUAL_LIGHTS(ADD_COLOURED, target)
    sum += area_irradiances(x, n) * (has_colour ? own : vec3(0.0));
    if (is_bad(sum)) {
        atomicAdd(bad_value_count, 1u);
        sum = vec3(0.0);
    }
    vec3 rest = max(radiosity[place].rgb - first[place].rgb, vec3(0.0));
    radiosity[close_first + slot] = vec4(sum + (shown ? rest : vec3(0.0)), has_albedo ? reflects_more(texel) : 0.0);
}
