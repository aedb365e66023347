#include "lanthorn/ui/label_places.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::ui {

namespace {

// A label that was put right above or below another differs from it by a line, but for rounding.
constexpr float kSlack = 0.01f;  // pixels

bool covers(const LabelPlace& a, const LabelPlace& b, float line) {
    return a.x < b.x + b.width && b.x < a.x + a.width && std::abs(a.y - b.y) < line - kSlack;
}

}  // namespace

std::optional<float> free_height(std::span<const LabelPlace> placed, const LabelPlace& wanted, float line,
                                 float low, float high) {
    const float here = std::clamp(wanted.y, low, high);
    std::optional<float> best;
    const auto consider = [&](float y) {
        const LabelPlace at{wanted.x, y, wanted.width};
        const bool nearer = !best || std::abs(y - here) < std::abs(*best - here);
        if (y >= low && y <= high && nearer &&
            std::ranges::none_of(placed, [&](const LabelPlace& other) { return covers(at, other, line); })) {
            best = y;
        }
    };
    consider(here);
    for (const LabelPlace& other : placed) {
        consider(other.y + line);
        consider(other.y - line);
    }
    return best;
}

}  // namespace lanthorn::ui
