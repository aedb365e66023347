// The indirect light at a point: eq. 10 of Frisvad et al. 2005 over the samples of the direct radiance maps. As in the paper each is
// taken to be seen from everywhere, or by what stands in the map about it (sample_pictures.h).
#ifndef LANTHORN_DRM_GATHER_GLSL
#define LANTHORN_DRM_GATHER_GLSL

#include "radiance_sample.h"
#include "solid_angle.glsl"

#ifdef SAMPLES_IN_BLOCK  // a uniform block is read much faster
layout(std140, binding = 1) uniform SampleBlock { RadianceSample radiance_samples[kMostBlockSamples]; };
#else
layout(std430, binding = 4) readonly buffer SampleList { RadianceSample radiance_samples[]; };
#endif

uniform int sample_count;      // at least 1
uniform int by_area;           // 1: eq. 14 or the disc's; 2: eq. 13; 0: `sent` has the solid angle
uniform float least_distance;  // metres, squared: what is nearer is that far

// Irradiance on a surface of unit `normal` at `x` (render space) by a sample, a share of RadianceSample::sent; `d`: the way to it.
float share_of_sample(RadianceSample s, vec3 d, vec3 normal) {
    float r2 = max(dot(d, d), least_distance);
    float here = max(dot(normal, d), 0.0);
    float there = max(-dot(s.normal, d), 0.0);
    if (by_area == 2) return drm_share_by_projection(here, there, r2);
    return by_area != 0 ? drm_share_by_area(here, there, s.area, r2) : drm_share_by_angle(here, r2);
}

// The same of what is seen of it.
float seen_share_of_sample(RadianceSample s, vec3 x, vec3 normal) {
    float share = share_of_sample(s, s.position - x, normal);
#ifdef SAMPLES_ARE_HIDDEN  // after hidden_sample.glsl; in programs of its own, as the branch alone costs others twice their time
    if (s.picture >= 0 && share > 0.0) share *= visibility_of_sample(s, x, normal);
#endif
    return share;
}

vec3 gathered_irradiance(vec3 x, vec3 normal) {
    vec3 sum = vec3(0.0);
    int i = 0;
    do {
        sum += radiance_samples[i].sent * seen_share_of_sample(radiance_samples[i], x, normal);
    } while (++i < sample_count);
    return sum;
}

#endif
