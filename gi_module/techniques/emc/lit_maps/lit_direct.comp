#version 450 core
// Direct irradiance of the listed lit texels, by the light maps, and what they reflect of it. Those that show something else than
// before begin with that: what the others reflect they learn from their rays.
layout(local_size_x = 256) in;

#include "engine/render/direct_irradiance.glsl"
#include "gi_module/techniques/emc/gather/point_lists.glsl"
#define BAD_VALUES_BINDING 7
#include "gi_module/shared/bad_values.glsl"

// By place.
layout(std430, binding = 3) writeonly buffer Radiosity { vec4 radiosity[]; };  // lux
layout(std430, binding = 4) writeonly buffer Direct { vec4 direct[]; };  // lux
layout(std430, binding = 5) writeonly buffer First { vec4 first[]; };    // lux
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };
uniform samplerBuffer lit_points;
uniform samplerBuffer lit_albedo;
uniform bool looked;             // at the maps, in this frame
uniform usamplerBuffer changed;  // a bit a texel, of the last look

void main() {
    uint i = work_item();
    if (i >= listed_count) return;
    int place = int(list[i]);
    vec4 point = texelFetch(lit_points, place);
    vec3 e = direct_irradiance(point.xyz, point_normal(point));
    if (is_bad(e)) {
        atomicAdd(bad_value_count, 1u);
        e = vec3(0.0);
    }
    direct[place] = vec4(e, 0.0);
    vec4 reflected = vec4(texelFetch(lit_albedo, place).rgb * e, 0.0);
    first[place] = reflected;
    if (looked && (texelFetch(changed, place >> 5).r >> (place & 31) & 1u) != 0u) radiosity[place] = reflected;
}
