// NaNs and infinities: told by their bits, since a compiler may take isnan() for false, replaced where they arise, and counted.
// BAD_VALUES_BINDING: where the including shader has room for the counter.
#ifndef LANTHORN_BAD_VALUES_GLSL
#define LANTHORN_BAD_VALUES_GLSL

layout(std430, binding = BAD_VALUES_BINDING) buffer BadValues { uint bad_value_count; };

bool is_bad(vec3 v) {
    uvec3 exponent = floatBitsToUint(v) & 0x7f800000u;
    return any(equal(exponent, uvec3(0x7f800000u)));
}

#endif
