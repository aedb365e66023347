// What the composite keeps from frame to frame (Composite::state_).
layout(std430, binding = 4) buffer CompositeState {
    float exposure;           // factor from nits to display-linear
    float average_luminance;  // nits, of the frame before smoothing
    uint nan_count;
    uint reserved;
    vec4 around;  // rgb: nits, the picture's mean where it is lit, of no more luminance than the average
} state;

bool is_bad(vec3 v) {
    // By bits: a compiler may take isnan() for false.
    uvec3 exponent = floatBitsToUint(v) & 0x7f800000u;
    return any(equal(exponent, uvec3(0x7f800000u)));
}
