// Flames that shine in pictures alone: no light comes from them, and nothing sees them but cameras.
#pragma once

#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::render {

struct Glow {
    dvec3 foot{0}, tip{0};  // world space, metres
    float width = 0.04f;    // metres, where it is widest
    vec3 nits{0};           // at its brightest; what is behind it shows through at its foot and rim alone
    bool operator==(const Glow&) const = default;
};

// As a resource of an App they are drawn in every view, until the program alters them.
struct Glows {
    std::vector<Glow> glows;
};

}  // namespace lanthorn::render
