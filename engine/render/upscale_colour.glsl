// Colours as differences of brightness and hue (Malvar and Sullivan 2003, "YCoCg-R"): linear, so that means stay means.
#ifndef LANTHORN_UPSCALE_COLOUR_GLSL
#define LANTHORN_UPSCALE_COLOUR_GLSL

vec3 ycocg(vec3 c) {
    return vec3(0.25 * c.r + 0.5 * c.g + 0.25 * c.b, 0.5 * (c.r - c.b), 0.5 * c.g - 0.25 * (c.r + c.b));
}

bool is_bad(vec4 v) {  // by bits: a compiler may take isnan() for false
    uvec4 exponent = floatBitsToUint(v) & 0x7f800000u;
    return any(equal(exponent, uvec4(0x7f800000u)));
}

vec3 from_ycocg(vec3 c) {
    float t = c.x - c.z;
    return vec3(t + c.y, c.x + c.z, t - c.y);
}

#endif
