// How large the surface is whose photons each coarse texel counts: the sum over the parts of the lit texels that it is the home of.
#ifndef LANTHORN_EMC_LIT_PHOTON_PARTS_GLSL
#define LANTHORN_EMC_LIT_PHOTON_PARTS_GLSL

layout(std430, binding = 5) buffer Sums { uint sums[]; };  // by place of the coarse texel: two words
#include "fixed_sums.glsl"

uniform float units;  // a square metre

// Adds the parts of a lit texel (m^2; 0: none) to the sum of its home (place + 1; 0: none), or takes them away. Parts in a row
// count as one.
void count_parts(uint home, vec4 parts, bool away) {
    int k = 0;
    while (home != 0u && k < 4) {
        float row = 0.0;
        while (k < 4 && parts[k] > 0.0) {
            row += parts[k];
            ++k;
        }
        if (away) {
            take_units(home - 1u, row * units);
        } else {
            add_units(home - 1u, row * units);
        }
        ++k;
    }
}

#endif
