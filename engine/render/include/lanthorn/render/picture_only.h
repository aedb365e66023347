// What pictures alone show: flames, and how single things look. No light, map, ray or sensor knows of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::render {

// A flame that shines in pictures: no light comes from it, and nothing sees it but cameras.
struct Glow {
    dvec3 foot{0}, tip{0};  // world space, metres; where they are one it is left out
    float width = 0.04f;    // metres, where it is widest; 0 or less: it is left out
    vec3 nits{0};           // at its brightest; what is behind it shows through at its foot and rim alone
    bool operator==(const Glow&) const = default;
};

// As a resource of an App they are drawn in every view, until the program alters them. O(pixels that they
// cover).
struct Glows {
    std::vector<Glow> glows;
};

// How a thing looks.
struct Look {
    std::uint32_t id = 0;  // Instance::id
    float shown = 1;       // share of its pixels that cameras see, 0..1; the others show what is behind it
    bool rim = false;      // it is covered with the fuzz of RenderSettings::rim
    bool operator==(const Look&) const = default;
};

// As a resource of an App they hold in every view, until the program alters them: for what is solid or
// masked. In order of id, each once.
struct Looks {
    std::vector<Look> looks;

    // Null: as all others. O(log looks).
    const Look* find(std::uint32_t id) const {
        const auto found = std::ranges::lower_bound(looks, id, {}, &Look::id);
        return found != looks.end() && found->id == id ? &*found : nullptr;
    }
    bool have_rims() const { return std::ranges::any_of(looks, &Look::rim); }  // any of them; O(looks)
    bool operator==(const Looks&) const = default;
};

}  // namespace lanthorn::render
