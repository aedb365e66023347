// A glow in a picture, as C++ and glow.vert have it.
#ifndef LANTHORN_GLOW_DATA_H
#define LANTHORN_GLOW_DATA_H
#ifdef __cplusplus
#include "lanthorn/core/math.h"
namespace lanthorn::render {
using uint = unsigned;
#endif

const uint kPictureGlowsBinding = 0u;  // storage buffer of PictureGlow

struct PictureGlow {
    vec4 foot;  // relative to the camera, metres; a: width, metres
    vec4 tip;   // likewise
    vec4 nits;  // rgb: at its brightest
};

#ifdef __cplusplus
static_assert(sizeof(PictureGlow) == 48);
}  // namespace lanthorn::render
#endif
#endif
