// What both passes of PrefixSums share: a work group for a block of counts, a few of them an invocation.
#ifndef LANTHORN_PREFIX_SUMS_GLSL
#define LANTHORN_PREFIX_SUMS_GLSL

layout(local_size_x = 256) in;

const int kOwn = 8;  // counts of an invocation
const int kBlock = 256 * kOwn;

uniform usamplerBuffer counts;
uniform int count;

shared uint shared_sums[256];

int own_first() { return min(int(gl_WorkGroupID.x) * kBlock + int(gl_LocalInvocationID.x) * kOwn, count); }
int own_end() { return min(own_first() + kOwn, count); }

uint own_sum() {
    uint sum = 0u;
    for (int i = own_first(); i < own_end(); ++i) sum += texelFetch(counts, i).r;
    return sum;
}

#endif
