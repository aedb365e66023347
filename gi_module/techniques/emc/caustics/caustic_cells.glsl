// Irradiance by caustic photons at any point: caustic_cells.h. Needs engine/render/octahedral.glsl.
#ifndef LANTHORN_EMC_CAUSTIC_CELLS_GLSL
#define LANTHORN_EMC_CAUSTIC_CELLS_GLSL


uniform usamplerBuffer caustic_words;
uniform samplerBuffer caustic_samples;  // PhotonHit, two texels each: power is the irradiance there
uniform int caustic_straight;            // of them, the first: of light that nothing has scattered
uniform uint caustic_slots;
uniform float caustic_finest;
uniform int caustic_sizes;

// Mesa's llvmpipe ends an invocation's loops, silently, after 65535 turns in all.
const uint kMostOfCell = 4000u;

uint caustic_slot(ivec3 cell, int size) {
    uint x = uint(cell.x) * 73856093u ^ uint(cell.y) * 19349663u ^ uint(cell.z) * 83492791u ^ uint(size) * 2654435769u;
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    return x & (caustic_slots - 1u);
}

// Most of what a cell lists lies too far off: a first loop, which does little, finds what counts.
vec3 caustics_at(vec3 x, vec3 n, float thin) {
    vec4 straight = vec4(0.0);
    vec4 scattered = vec4(0.0);
    float samples = 0.0;
    float side = caustic_finest;
    for (int size = 0; size < caustic_sizes; ++size) {
        int slot = 2 * int(caustic_slot(ivec3(floor(x / side)), size));
        int first = int(texelFetch(caustic_words, slot).r);
        int last = first + int(min(texelFetch(caustic_words, slot + 1).r, kMostOfCell));
        // Those of other cells and sizes that share the slot are asked where they belong.
        float narrowest = size == 0 ? 0.0 : side * 0.499;
        while (first < last) {
            uint near = 0u;  // a bit each
            int i = first;
            do {
                vec4 place = texelFetch(caustic_samples, 2 * int(texelFetch(caustic_words, i).r));  // position, radius
                vec3 d = place.xyz - x;
                bool counts = place.w <= side * 1.001 && place.w > narrowest && dot(d, d) < place.w * place.w;
                near |= counts ? 1u << uint(i - first) : 0u;
            } while (++i < min(first + 32, last));
            while (near != 0u) {
                int index = int(texelFetch(caustic_words, first + findLSB(near)).r);
                near &= near - 1u;
                vec4 place = texelFetch(caustic_samples, 2 * index);
                vec4 load = texelFetch(caustic_samples, 2 * index + 1);  // irradiance, normal
                vec3 d = place.xyz - x;
                vec3 m = octahedral_decode(unpackSnorm2x16(floatBitsToUint(load.w)));
                float turn = dot(m, n);
                bool same = turn >= 0.25 && abs(0.5 * dot(d, n + m)) <= 0.25 * place.w + thin;
                float kernel = same ? (1.0 - dot(d, d) / (place.w * place.w)) * turn : 0.0;
                vec4 value = vec4(load.rgb, 1.0) * (kernel / (place.w * place.w));
                bool is_straight = index < caustic_straight;
                samples += is_straight ? kernel : 0.0;
                straight += is_straight ? value : vec4(0.0);
                scattered += is_straight ? vec4(0.0) : value;
            }
            first += 32;
        }
        side *= 2.0;
    }
    // Beyond the rim of a caustic there are few samples, and they know too much.
    return straight.rgb * (min(samples, 1.0) / max(straight.a, 1e-30)) + scattered.rgb / max(scattered.a, 1e-30);
}

#endif
