// How far a point of the picture trusts its own rays: the more it knows itself, the less it asks its neighbours.
#ifndef LANTHORN_EMC_GATHER_TRUST_GLSL
#define LANTHORN_EMC_GATHER_TRUST_GLSL

const float kFewRays = 48.0;  // pooled over more points

int filter_levels(float rays) { return rays < 12.0 ? 4 : 3; }

// Deviations that luminances on one surface may differ by: of few rays, whose deviation is uncertain, and of many. Rays that a
// moving camera has gathered from here and there are no longer spread evenly, and err more than their number tells.
float sigma_of(float rays, float least) { return mix(4.0, least, clamp(rays * (1.0 / 64.0), 0.0, 1.0)); }

#endif
