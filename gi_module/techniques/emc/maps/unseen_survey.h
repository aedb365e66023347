// Where the picture lacks environment maps, as a survey of its rays has found it. No GL.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gi {

// A ray that met what no ordinary map shows, for `rays` like it.
struct UnseenPlace {
    vec3 start{0};  // render space
    vec3 place{0};
    float rays = 0;
};

struct UnseenSurvey {
    double rays = 0;           // of the picture, that are remembered
    double unknown = 0;        // of them, that met what no lit texel shows
    double unseen = 0;         // of those, about, that met what no map sees at all
    std::uint64_t points = 0;  // of the picture
    std::uint64_t blind = 0;   // of them, those a quarter of whose rays are unknown
    std::vector<UnseenPlace> places;
};

}  // namespace lanthorn::gi
