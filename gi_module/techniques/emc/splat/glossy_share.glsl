// Of which pixels photons light the lobe. Behind specular_pixel.glsl.
#ifndef LANTHORN_EMC_GLOSSY_SHARE_GLSL
#define LANTHORN_EMC_GLOSSY_SHARE_GLSL

// From this roughness on lobes are lit by irradiance; the two ways are blended over 0.15 below it. kGlossyRoughness of glossy_splats.h.
const float kGlossyRoughness = 0.75;
const float kLeastReflected = 0.02;  // of even light: what is less is not seen

// What of the pixel's lobe rays do not bring and irradiance tells too little of.
float glossy_share(SpecularPixel s, float roughness) {
    float reflected = max(s.specular.r, max(s.specular.g, s.specular.b));
    bool shows = s.seen && reflected > kLeastReflected;
    return shows ? (1.0 - s.traced) * traced_share(roughness, kGlossyRoughness) : 0.0;
}

#endif
