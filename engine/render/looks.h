// How single things look in pictures alone: no light, map, ray or sensor knows of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lanthorn::render {

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
    bool have_rims() const { return std::ranges::any_of(looks, &Look::rim); }
    bool operator==(const Looks&) const = default;
};

}  // namespace lanthorn::render
