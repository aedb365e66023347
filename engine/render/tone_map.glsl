// From display-linear light (1 = diffuse white after exposure) to what a screen shows.
#ifndef LANTHORN_TONE_MAP_GLSL
#define LANTHORN_TONE_MAP_GLSL

// ACES filmic, fitted by Stephen Hill (BakingLab, MIT licence): RRT and ODT with the sRGB primaries folded in.
vec3 tone_map_aces(vec3 c) {
    const mat3 input_matrix = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
    const mat3 output_matrix =
        mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
    c = input_matrix * c;
    c = (c * (c + 0.0245786) - 0.000090537) / (c * (0.983729 * c + 0.4329510) + 0.238081);
    return clamp(output_matrix * c, 0.0, 1.0);
}

// Khronos PBR Neutral (Khronos 2024): base colours stay what they are up to 0.8 less the Fresnel offset.
vec3 tone_map_neutral(vec3 c) {
    const float start = 0.8 - 0.04;
    const float desaturation = 0.15;
    float x = min(c.r, min(c.g, c.b));
    float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
    c -= offset;
    float peak = max(c.r, max(c.g, c.b));
    if (peak < start) return c;
    float d = 1.0 - start;
    float new_peak = 1.0 - d * d / (peak + d - start);
    c *= new_peak / peak;
    float g = 1.0 - 1.0 / (desaturation * (peak - new_peak) + 1.0);
    return mix(c, vec3(new_peak), g);
}

// What is brighter than white is drawn together by the logarithm of how much, and keeps its hue, before it is tone mapped (Drago et
// al. 2003, "Adaptive Logarithmic Mapping for Displaying High Contrast Scenes"; the ratio of channels kept as Schlick 1994 does):
// of the brightest channel m there stays 1 + w ln(1 + (m - 1) / w), which leaves white with a slope of 1.
vec3 draw_together(vec3 c, float w) {
    float most = max(c.r, max(c.g, c.b));
    return most > 1.0 ? c * ((1.0 + w * log(1.0 + (most - 1.0) / w)) / most) : c;
}

vec3 srgb_encode(vec3 c) {
    c = clamp(c, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

#endif
