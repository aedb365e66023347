// A line in a picture, as C++ and line.vert have it.
#ifndef LANTHORN_LINE_DATA_H
#define LANTHORN_LINE_DATA_H
#ifdef __cplusplus
#include "lanthorn/core/math.h"
namespace lanthorn::render {
using uint = unsigned;
#endif

const uint kPictureLinesBinding = 0u;  // storage buffer of PictureLine

struct PictureLine {
    vec2 from;  // pixels from the lower left
    vec2 to;
    vec4 colour;
    float from_depth;  // as the depth buffer has it: reversed
    float to_depth;
    float width;  // pixels
    float unused;
};

#ifdef __cplusplus
static_assert(sizeof(PictureLine) == 48);
}  // namespace lanthorn::render
#endif
#endif
