// The photons of a tile whose splats reach a block of 8 x 8 pixels. The invocations of a work group find them, each a share, in the
// order of the tile's list, so that sums over them are the same in every run. Whoever includes this has local_size_x = 8, and
//   uniform samplerBuffer photon_hits;  // PhotonHit, two texels each
//   float radius_of(vec4 place);        // of a splat, metres; `place`: the first texel
#include "gi_module/techniques/emc/splat/splat_tiles.glsl"

const int kLanes = 8;  // as many as a software rasteriser does together: what they all need of a photon is fetched once
const int kSide = 8;   // of the block
const int kPixels = 8;  // an invocation
const int kShare = 32;  // photons that an invocation tries on the block at once

shared vec3 lowers[kLanes];
shared vec3 uppers[kLanes];
shared int counts[kLanes];
shared int touching[kShare * kLanes];  // photons

// The k-th pixel of an invocation.
ivec2 block_pixel(ivec2 corner, int lane, int k) {
    return corner + ivec2(lane % kSide, lane / kSide + k * (kLanes / kSide));
}

// The box around those of all invocations.
void join_boxes(int lane, inout vec3 lower, inout vec3 upper) {
    lowers[lane] = lower;
    uppers[lane] = upper;
    barrier();
    for (int width = kLanes / 2; width > 0; width >>= 1) {
        if (lane < width) {
            lowers[lane] = min(lowers[lane], lowers[lane + width]);
            uppers[lane] = max(uppers[lane], uppers[lane + width]);
        }
        barrier();
    }
    lower = lowers[0];
    upper = uppers[0];
}

// Writes those of the entries `run` to `run` + kShare * kLanes that reach the box into `touching`, and returns how many. A barrier()
// must lie between the use of them and the next call.
int find_touching(TileList list, int run, int last, int lane, vec3 lower, vec3 upper) {
    int begin = run + kShare * lane;
    uint mine = 0u;
    for (int i = 0; i < kShare; ++i) {
        vec4 place = texelFetch(photon_hits, 2 * photon_of(list, min(begin + i, last - 1)));
        float radius = radius_of(place);
        vec3 d = max(max(lower - place.xyz, place.xyz - upper), vec3(0.0));
        mine |= begin + i < last && dot(d, d) < radius * radius ? 1u << uint(i) : 0u;
    }
    counts[lane] = bitCount(mine);
    barrier();
    int total = 0;
    int at = 0;
    for (int k = 0; k < kLanes; ++k) {
        at += k < lane ? counts[k] : 0;
        total += counts[k];
    }
    while (mine != 0u) {
        touching[at++] = photon_of(list, begin + findLSB(mine));
        mine &= mine - 1u;
    }
    barrier();
    return total;
}
