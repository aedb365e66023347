#version 450 core
// Power and area under a wider kernel: the sum over 3 x 3 coarse texels of a face, as far apart as `level` says, on one surface
// that goes on between them.
layout(local_size_x = 256) in;

layout(std430, binding = 0) readonly buffer PointHeader { uint point_count; };
layout(std430, binding = 3) readonly buffer Keys { uint keys[]; };
layout(std430, binding = 4) writeonly buffer Wider { vec4 wider[]; };  // as narrower

#include "gi_module/techniques/emc/gather/point_lists.glsl"

uniform samplerBuffer narrower;  // by place: rgb lumen; a m^2
uniform usamplerBuffer links;    // by place: lit_photon_links.comp
uniform int coarse_resolution;
uniform int level;               // 1, 2, 3: texels 1, 2, 4 apart

void main() {
    uint i = work_item();
    if (i >= point_count) return;
    if (keys[i] == kNoPoint) return;
    int place = int(keys[i]);
    uint reached = texelFetch(links, place).r >> (8 * (level - 1));
    int spacing = 1 << (level - 1);
    vec4 sum = texelFetch(narrower, place);
    for (int k = 0; k < 8; ++k) {
        int ring = k < 4 ? k : k + 1;
        ivec2 towards = ivec2(ring % 3, ring / 3) - 1;
        float weight = (towards.x == 0 ? 1.0 : 0.5) * (towards.y == 0 ? 1.0 : 0.5);
        bool reaches = (reached >> k & 1u) != 0u;
        int at = reaches ? place + spacing * (towards.y * coarse_resolution + towards.x) : place;
        sum += (reaches ? weight : 0.0) * texelFetch(narrower, at);
    }
    wider[place] = sum;
}
