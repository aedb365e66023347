// Which specular lobes are traced by indirect light (TracedLobes in frame.h).
#ifndef LANTHORN_TRACED_LOBES_GLSL
#define LANTHORN_TRACED_LOBES_GLSL

// The share of the lobe that is traced.
float traced_share(float roughness, float traced_roughness) {
    return clamp((traced_roughness - roughness) / 0.15, 0.0, 1.0);
}

#endif
