// What is mirrored in the picture, or seen through it: rays from its pixels and where they end. The C++ side: specular_ray.h.
#ifndef LANTHORN_MIRRORS_SPECULAR_GLSL
#define LANTHORN_MIRRORS_SPECULAR_GLSL

struct SpecularRay {
    vec3 origin;
    uint pixel;
    vec3 direction;
    uint through;
};

const uint kNothingKnown = 0u;
const uint kMetSurface = 1u;
const uint kMetSky = 2u;

struct SpecularHit {
    vec3 position;
    uint kind;
    vec3 normal;
    float spread;
    vec3 reflectance;
    uint emitter;
    vec3 emission;
    uint next;  // index of another end of the same ray; 0: there is none
};

const float kSpread = 2.0;

// What one of a pixel's two rays has brought, at 2 * pixel + through.
struct SpecularSample {
    vec3 radiance;  // nits; of a ray that leaves in one direction alone: without `lobe`
    float known;    // 0: there is no ray, or nothing is known; 1; kSpread: one direction of a lobe on the way
    vec3 lobe;      // density < 0: what came by one direction of a lobe on the way, nits; else the direction in which the ray left
    float density;  // probability per solid angle that it did; < 0: a mirror's, which leaves in one alone
};

#endif
