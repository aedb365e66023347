// What a direct radiance map is made of, as the shaders read it (std430, std140). Included by C++ and by
// GLSL: keep to both.
#ifndef LANTHORN_DRM_RADIANCE_SAMPLE_H
#define LANTHORN_DRM_RADIANCE_SAMPLE_H

#ifdef __cplusplus
#include "lanthorn/core/math.h"

namespace lanthorn::gi {
#endif

// Storage buffer bindings, beside render::kLightsBinding: the light of each picture.
const uint kPicturesBinding = 3u;
const uint kSamplesBinding = 4u;
// Of the uniform block, of the smallest allowed size, that holds the samples where they are few enough.
const uint kSampleBlockBinding = 1u;
const uint kMostBlockSamples = 256u;

// LightPicture::shape: how a square becomes the directions, or the ground, that a light shines to. Every part
// of the square gets its share of the light's solid angle (sphere, cone), cosine (hemisphere) or ground
// (parallel).
const uint kPictureSphere = 0u;
const uint kPictureCone = 1u;
const uint kPictureHemisphere = 2u;
const uint kPictureParallel = 3u;

// What one light sees, as a square.
struct LightPicture {
    uint shape;
    uint drawn_here;  // 1: in the maps of emissive surfaces, 0: in the light maps
    uint unused0;
    uint unused1;
    vec4 window;  // parallel: least and greatest metres along the light's right and up
};

// A part of the surfaces that a light shines on, and what it sends on.
struct RadianceSample {
    vec3 position;  // render space
    float area;     // m^2; with the disc's solid angle, over pi
    vec3 normal;    // unit, on the lit side; 0: sends nothing
    float across;   // m^2 across the light's way
    // rgb: what is sent on. By area: reflected lumen over pi, an irradiance once times cos cos' / (area +
    // r^2). Else nits times steradians, an irradiance once times cos.
    vec3 sent;
    int picture;  // the first of six layers of what it sees (sample_pictures.h); -1: it is seen from
                  // everywhere
    vec3 place;   // of the lit surface, next to the position: where it looks from
    float unused;
};

#ifdef __cplusplus
static_assert(sizeof(LightPicture) == 32);
static_assert(sizeof(RadianceSample) == 64);
}  // namespace lanthorn::gi
#endif
#endif
