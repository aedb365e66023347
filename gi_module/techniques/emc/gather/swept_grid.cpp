#include "gi_module/techniques/emc/gather/swept_grid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lanthorn::gi {

namespace {

constexpr float kSlack = 0.02f;  // of a cell, that rounding may take a ray beside where it is

}  // namespace

void SweptGrid::fill(std::span<const Aabb> boxes, float margin) {
    columns_.clear();
    if (boxes.empty()) {
        return;
    }
    bounds_ = {};
    for (const Aabb& box : boxes) {
        bounds_.add(box);
    }
    // What is flat has cells, too.
    const float around = margin + 1e-3f * bounds_.diagonal();
    bounds_ = {bounds_.lower - around, bounds_.upper + around};
    const vec3 size = bounds_.size();
    up_ = size.x < size.y ? (size.x < size.z ? 0 : 2) : (size.y < size.z ? 1 : 2);
    const std::array<int, 3> axes{(up_ + 1) % 3, (up_ + 2) % 3, up_};
    columns_.resize(std::size_t{kSide} * kSide);
    for (const Aabb& box : boxes) {
        std::array<std::uint32_t, 3> first{}, last{};
        for (std::size_t k = 0; k < 3; ++k) {
            const int axis = axes[k];
            const float most = static_cast<float>(k < 2 ? kSide : kLayers) - 1;
            const float scale = cells_a_metre()[axis];
            const auto cell_of = [&](float x, float slack) {
                return static_cast<std::uint32_t>(
                    std::clamp(std::floor((x - bounds_.lower[axis]) * scale + slack), 0.0f, most));
            };
            first[k] = cell_of(box.lower[axis] - margin, -kSlack);
            last[k] = cell_of(box.upper[axis] + margin, kSlack);
        }
        const std::uint32_t bits = (~0u >> (kLayers - 1 - last[2])) & (~0u << first[2]);
        for (std::uint32_t v = first[1]; v <= last[1]; ++v) {
            for (std::uint32_t u = first[0]; u <= last[0]; ++u) {
                columns_[v * kSide + u] |= bits;
            }
        }
    }
}

vec3 SweptGrid::cells_a_metre() const {
    const vec3 size = bounds_.size();
    vec3 cells(static_cast<float>(kSide));
    cells[up_] = static_cast<float>(kLayers);
    return cells / size;
}

}  // namespace lanthorn::gi
