// How far a point of the picture trusts its own rays: the more it knows itself, the less it asks its neighbours.
#ifndef LANTHORN_EMC_GATHER_TRUST_GLSL
#define LANTHORN_EMC_GATHER_TRUST_GLSL

const float kFewRays = 48.0;  // pooled over more points

int filter_levels(float rays) { return rays < 12.0 ? 4 : rays < kFewRays ? 3 : 2; }

// Deviations that luminances on one surface may differ by: of few rays, whose deviation is uncertain, and of many.
float sigma_of(float rays) { return mix(4.0, 2.0, clamp(rays * (1.0 / 64.0), 0.0, 1.0)); }

#endif
