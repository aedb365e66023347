#version 450 core
// Mixes each listed pixel with its neighbour across the edge. An edge that is nearly a row is a staircase: where a
// step of L pixels begins and ends, the true edge passes half a pixel off it, in the middle it passes through.
#include "fxaa.glsl"

layout(local_size_x = 64) in;
layout(rgba8, binding = 0) uniform writeonly image2D smoothed;

const int kFarthest = 12;           // pixels along the edge in which the step's ends are looked for
const float kThinBlur = 0.75;       // of what is as thin as a pixel, 0..1
const float kEdgeGoesOn = 0.25;     // of the step across: what luma along the edge may vary by

// How far the edge goes on from p along `along`: to the middle between the last pixel of it and the first of what
// is not. `end` becomes the luma there less that of the edge.
float reach(ivec2 p, ivec2 along, ivec2 across, float edge, float most, out float end) {
    float distance = float(kFarthest);
    bool found = false;
    end = 0.0;
    for (int i = 1; i <= kFarthest; ++i) {
        ivec2 q = p + i * along;
        float difference = 0.5 * (luma_at(q) + luma_at(q + across)) - edge;
        if (!found) {
            end = difference;
            if (abs(difference) >= most) {
                found = true;
                distance = float(i) - 0.5;
            }
        }
    }
    return distance;
}

void main() {
    uint index = (gl_WorkGroupID.y * kRow + gl_WorkGroupID.x) * kSmoothGroup + gl_LocalInvocationID.x;
    if (index >= edges.count) return;
    ivec2 size = textureSize(picture, 0);
    ivec2 p = ivec2(int(edges.pixels[index]) % size.x, int(edges.pixels[index]) / size.x);

    vec3 colour = colour_at(p);
    float m = luma(colour);
    float n = luma_at(p + ivec2(0, 1)), s = luma_at(p - ivec2(0, 1));
    float e = luma_at(p + ivec2(1, 0)), w = luma_at(p - ivec2(1, 0));
    float ne = luma_at(p + ivec2(1, 1)), nw = luma_at(p + ivec2(-1, 1));
    float se = luma_at(p + ivec2(1, -1)), sw = luma_at(p - ivec2(1, 1));

    float rows = 2.0 * abs(n + s - 2.0 * m) + abs(ne + se - 2.0 * e) + abs(nw + sw - 2.0 * w);
    float columns = 2.0 * abs(e + w - 2.0 * m) + abs(ne + nw - 2.0 * n) + abs(se + sw - 2.0 * s);
    bool in_row = rows >= columns;  // the edge's direction is nearer to the x axis
    float ahead = in_row ? n : e, behind = in_row ? s : w;
    float sign_across = abs(ahead - m) >= abs(behind - m) ? 1.0 : -1.0;
    float other = sign_across > 0.0 ? ahead : behind;
    ivec2 across = int(sign_across) * (in_row ? ivec2(0, 1) : ivec2(1, 0));
    ivec2 along = in_row ? ivec2(1, 0) : ivec2(0, 1);

    float edge = 0.5 * (m + other);
    float most = kEdgeGoesOn * abs(other - m);
    float end_a, end_b;
    float a = reach(p, along, across, edge, most, end_a);
    float b = reach(p, -along, across, edge, most, end_b);
    // Beyond the nearer end both sides are of the other's kind where the true edge passes through this pixel.
    float end = a < b ? end_a : end_b;
    bool passes = abs(end) >= most && (end < 0.0) != (m < edge);
    float step_mix = passes ? 0.5 - min(a, b) / (a + b) : 0.0;

    // What is as thin as a pixel differs from all around it, and is mixed by how much (Lottes 2009).
    float mean = (2.0 * (n + s + e + w) + ne + nw + se + sw) / 12.0;
    float range = max(m, max(max(n, s), max(e, w))) - min(m, min(min(n, s), min(e, w)));
    float thin = smoothstep(0.0, 1.0, clamp(abs(mean - m) / max(range, 1e-4), 0.0, 1.0));
    float mixed = max(step_mix, kThinBlur * thin * thin);

    imageStore(smoothed, p, vec4(mix(colour, colour_at(p + across), mixed), 1.0));
}
