#include "tools/editor/window/pivot.h"

#include <cmath>

namespace lanthorn::edit_window {

namespace {
constexpr float kNear = 0.1f;  // of the bounds' size
}

bool origin_is_meant(const Aabb& bounds, const vec3& origin) {
    const vec3 size = bounds.size(), middle = bounds.centre();
    for (int i = 0; i < 3 && !bounds.empty(); ++i) {
        const float slack = kNear * size[i] + 1e-4f;
        const auto at = [&](float place) { return std::abs(origin[i] - place) <= slack; };
        if (!at(bounds.lower[i]) && !at(middle[i]) && !at(bounds.upper[i])) {
            return false;
        }
    }
    return true;
}

}  // namespace lanthorn::edit_window
