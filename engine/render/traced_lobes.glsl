// Which specular lobes are traced by indirect light (TracedLobes in frame.h).
#ifndef LANTHORN_TRACED_LOBES_GLSL
#define LANTHORN_TRACED_LOBES_GLSL

const float kLobeRays = 16.0;  // of a pixel and its neighbours, that tell of a lobe

// The share of the lobe that is traced.
float traced_share(float roughness, float traced_roughness) {
    return clamp((traced_roughness - roughness) / 0.15, 0.0, 1.0);
}

// Of what area lights send along a traced lobe, the share that its rays bring: the wider the lobe and the smaller the light, the less,
// since hardly a ray meets it then; the rest is direct light's (power heuristic, Veach and Guibas 1995). `density`: of the rays, a
// steradian; `solid_angle`: that the light's nearest sample stands for.
float share_of_rays(float density, float solid_angle) {
    float met = kLobeRays * density * solid_angle;
    return met * met / (met * met + 1.0);
}

#endif
