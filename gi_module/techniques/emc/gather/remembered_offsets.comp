#version 450 core
// Where the rays of each point begin in their list: the sum of the counts before. One work group.
layout(local_size_x = 256) in;

layout(std430, binding = 2) writeonly buffer Offsets { uint offsets[]; };

uniform usamplerBuffer counts;
uniform int capacity;

shared uint sums[256];

void main() {
    int share = (capacity + 255) / 256;
    int first = int(gl_LocalInvocationID.x) * share;
    int end = min(first + share, capacity);
    uint sum = 0u;
    for (int i = first; i < end; ++i) sum += texelFetch(counts, i).r;
    sums[gl_LocalInvocationID.x] = sum;
    barrier();
    uint before = 0u;
    for (uint k = 0u; k < gl_LocalInvocationID.x; ++k) before += sums[k];
    for (int i = first; i < end; ++i) {
        offsets[i] = before;
        before += texelFetch(counts, i).r;
    }
}
