#version 450 core
// Pixels whose lobes photons light (gi.emc.splat.glossy): the share of the lobe, and a list of them for splat_boundaries.comp.
layout(local_size_x = 8, local_size_y = 8) in;

#include "gi_module/shared/mirrors/specular_pixel.glsl"
#include "glossy_share.glsl"
#include "splat_lists.glsl"

layout(rgba32f, binding = 0) writeonly uniform image2D glossy;
layout(std430, binding = 4) writeonly buffer NewPixels { uint new_pixels[]; };

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, image_size))) return;
    float share = glossy_share(specular_pixel(p), texelFetch(gbuffer_material, p, 0).r);
    imageStore(glossy, p, vec4(0.0, 0.0, 0.0, share));
    if (share <= 0.0) return;
    uint at = atomicAdd(new_count, 1u);
    new_pixels[at] = uint(p.x) | (uint(p.y) << 16u);
    COUNT_GROUPS(new_groups, at, at, 64u)
}
