// What is drawn over a picture as a rectangle each, as C++, glow.vert and line.vert have it.
#ifndef LANTHORN_STRIP_DATA_H
#define LANTHORN_STRIP_DATA_H
#ifdef __cplusplus
#include "lanthorn/core/math.h"
namespace lanthorn::render {
using uint = unsigned;
#endif

const uint kPictureStripsBinding = 0u;  // storage buffer of one kind of them

struct PictureLine {
    vec2 from;  // pixels from the lower left
    vec2 to;
    vec4 colour;
    float from_depth;  // as the depth buffer has it: reversed
    float to_depth;
    float width;  // pixels
    float unused;
};

struct PictureGlow {
    vec4 foot;  // relative to the camera, metres; a: width, metres
    vec4 tip;   // likewise
    vec4 nits;  // rgb: at its brightest
};

#ifdef __cplusplus
static_assert(sizeof(PictureLine) == 48 && sizeof(PictureGlow) == 48);
}  // namespace lanthorn::render
#endif
#endif
