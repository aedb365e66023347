// Direct irradiance of listed lit texels, and what they reflect of it. Those that show something else than before begin with that:
// what the others reflect they learn from their rays.
#ifndef LANTHORN_EMC_LIT_DIRECT_GLSL
#define LANTHORN_EMC_LIT_DIRECT_GLSL

#include "engine/render/direct_irradiance.glsl"
#include "lit_points.glsl"
#define BAD_VALUES_BINDING 1
#include "gi_module/shared/bad_values.glsl"

// By place.
layout(std430, binding = 3) writeonly buffer Radiosity { vec4 radiosity[]; };  // lux
layout(std430, binding = 4) writeonly buffer Direct { vec4 direct[]; };  // lux
layout(std430, binding = 5) buffer First { vec4 first[]; };  // lux; a: the texel's width over its distance from a lamp
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };
uniform samplerBuffer lit_albedo;
uniform bool looked;             // at the maps, in this frame
uniform usamplerBuffer changed;  // a bit a texel, of the last look
uniform vec4 map_centres[40];    // kMaxMaps

const float kNear = 3.0;  // texel widths to a lamp, below which the texel's middle does not speak for it

vec3 centre_of_map(int place) { return map_centres[place / (6 * lit_resolution * lit_resolution)].xyz; }

void set_direct(int place, vec3 e, float nearness) {
    if (is_bad(e)) {
        atomicAdd(bad_value_count, 1u);
        e = vec3(0.0);
    }
    direct[place] = vec4(e, 0.0);
    vec4 reflected = vec4(texelFetch(lit_albedo, place).rgb * e, 0.0);
    first[place] = vec4(reflected.rgb, nearness);
    if (looked && (texelFetch(changed, place >> 5).r >> (place & 31) & 1u) != 0u) radiosity[place] = reflected;
}

#endif
