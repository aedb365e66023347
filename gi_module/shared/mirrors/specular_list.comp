#version 450 core
// Which pixels may mirror or show what is behind them: all passes after this one are about these alone.
layout(local_size_x = 8, local_size_y = 8) in;

#include "specular.glsl"
#include "engine/gpu/work_items.glsl"
#include "engine/render/gbuffer_flags.glsl"

layout(std430, binding = 2) writeonly buffer Samples { SpecularSample samples[]; };
layout(std430, binding = 3) buffer Pixels { uint pixel_count; uint pixel_groups[3]; uint pixels[]; };

uniform ivec2 image_size;
uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_material;
uniform sampler2D gbuffer_emissive;
uniform float most_roughness;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, image_size))) return;
    uint pixel = uint(p.y * image_size.x + p.x);
    samples[2u * pixel].known = 0.0;
    samples[2u * pixel + 1u].known = 0.0;
    vec2 material = texelFetch(gbuffer_material, p, 0).ra;
    bool lit = texelFetch(gbuffer_distance, p, 0).r > 0.0 && !flags_say_unlit(material.y);
    bool listed = lit && (material.x < most_roughness || texelFetch(gbuffer_emissive, p, 0).a > 1e-3);
    if (!listed) return;
    uint at = atomicAdd(pixel_count, 1u);
    COUNT_GROUPS(pixel_groups, at, at, 64u)
    pixels[at] = pixel;
}
