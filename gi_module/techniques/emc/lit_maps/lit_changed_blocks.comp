#version 450 core
// Lists the blocks of lit texels that lit_texels.comp has marked, whose shader has no storage block left for a list.
layout(local_size_x = 256) in;

#include "engine/gpu/work_items.glsl"
#include "gi_module/techniques/emc/gather/entry_list.glsl"

layout(std430, binding = 3) readonly buffer Changed { uint changed[]; };  // from `first_word` on a bit a block

uniform uint first_word;
uniform uint words;

void main() {
    uint word = work_item();
    if (word >= words) return;
    uint bits = changed[first_word + word];
    if (bits == 0u) return;
    uint at = append_entries(uint(bitCount(bits)));
    while (bits != 0u) {
        appended[at++] = 32u * word + uint(findLSB(bits));
        bits &= bits - 1u;
    }
}
