#version 450 core
// After rays have been looked up: where more of them wanted a slot than there are, as many lots of them as all fit are to look again,
// and the others not. So it hangs on the rays alone which have one. The lists are emptied: of what is looked for in all maps, too.
layout(local_size_x = 1) in;

#include "close_free.glsl"

layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; };
layout(std430, binding = 7) writeonly buffer Left { uint left_count; uint left_groups[3]; };

void main() {
    bool too_many = close_taken > close_free_count;
    close_groups = uint[4](too_many ? listed_groups[0] : 0u, listed_groups[1], 1u, 0u);
    left_count = 0u;
    left_groups = uint[3](0u, 1u, 1u);
    if (!too_many) return;
    uint room = close_free_count - min(close_before, close_free_count);
    uint lots = 0u;
    while (lots < kCloseLots && close_wanted[lots] <= room) room -= close_wanted[lots++];
    close_lots = lots;
    close_taken = close_before;
}
