#version 450 core
// What the guides say of a cell: the root mean square of what rays met there. The tiles around count for some rays too, which tell
// while a tile has few of its own. A group a tile.
layout(local_size_x = 64) in;

#include "remembered_guide.glsl"

layout(std430, binding = 2) writeonly buffer Levels { float levels[]; };  // of the tile's mean

uniform usamplerBuffer guide;  // by cell of a tile: squares, rays
uniform samplerBuffer means;   // by tile, lux

const float kPrior = 2.0;    // rays of the tile's mean that a cell begins with
const float kAround = 32.0;  // rays that the tiles around count as, at most

void main() {
    ivec2 tiles = ivec2(gl_NumWorkGroups.xy);
    ivec2 p = ivec2(gl_WorkGroupID.xy);
    int tile = p.y * tiles.x + p.x;
    int cell = int(gl_LocalInvocationID.x);
    float mean = max(texelFetch(means, tile).r, 1e-20);
    vec2 around = vec2(0.0);  // sum of squares, rays
    for (int k = 0; k < 9; ++k) {
        ivec2 q = clamp(p + ivec2(k % 3, k / 3) - 1, ivec2(0), tiles - 1);
        int other = q.y * tiles.x + q.x;
        vec2 seen = vec2(texelFetch(guide, other * int(kGuideCells) + cell).rg);
        float scale = min(texelFetch(means, other).r / mean, 1e3);
        around += other == tile ? vec2(0.0) : seen * vec2(scale * scale / kGuideUnits, 1.0);
    }
    float rays = min(around.y, kAround);
    vec2 seen = vec2(texelFetch(guide, tile * int(kGuideCells) + cell).rg) * vec2(1.0 / kGuideUnits, 1.0);
    seen += vec2(rays * around.x / max(around.y, 1.0), rays) + kPrior;
    levels[tile * int(kGuideCells) + cell] = sqrt(seen.x / seen.y);
}
