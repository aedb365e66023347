#include "lanthorn/gi/emc/swept_boxes.h"

#include <cmath>
#include <limits>

namespace lanthorn::gi {

namespace {

Aabb around(const Aabb& a, const Aabb& b) {
    Aabb both = a;
    both.add(b);
    return both;
}

float area(const Aabb& box) {
    const vec3 size = box.size();
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Two of them become one, which carries nothing.
void merge_closest(std::vector<Mover>& movers) {
    std::size_t first = 0, second = 1;
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < movers.size(); ++i) {
        for (std::size_t j = i + 1; j < movers.size(); ++j) {
            const Aabb &a = movers[i].swept, &b = movers[j].swept;
            const float growth = area(around(a, b)) - area(a) - area(b);
            if (growth < least) {
                least = growth;
                first = i;
                second = j;
            }
        }
    }
    movers[first] = {.swept = around(movers[first].swept, movers[second].swept)};
    movers.erase(movers.begin() + static_cast<std::ptrdiff_t>(second));
}

}  // namespace

void SweptBoxes::follow(const FrameScene& scene) {
    movers_.clear();
    const auto add = [&](const Mover& mover) {
        if (!mover.swept.empty()) {
            movers_.push_back(mover);
        }
        if (movers_.size() > kMost) {
            merge_closest(movers_);
        }
    };
    const vec3 shift(origin_ - scene.origin);  // what was at p is now at p + shift
    const auto bounds_now = [&](const Placed& placed) -> Aabb {
        return {placed.bounds.lower + shift, placed.bounds.upper + shift};
    };
    const auto key = [](const auto& placed) { return std::pair(placed.id, placed.mesh); };
    std::vector<bool> moved(scene.instances.size(), false);
    for (const std::uint32_t i : scene.changes.moved) {
        moved[i] = true;
    }
    std::size_t last = 0;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& now = scene.instances[i];
        for (; last < placed_.size() && key(placed_[last]) < key(now); ++last) {
            add({.swept = bounds_now(placed_[last])});  // it is gone
        }
        const bool was_there = last < placed_.size() && key(placed_[last]) == key(now);
        if (moved[i] && was_there) {
            mat4 before = placed_[last].transform;
            before[3] += vec4(shift, 0);
            const bool rigid = std::abs(glm::determinant(before)) > 0;
            const Aabb was = bounds_now(placed_[last]);
            add({was, around(was, now.bounds), rigid ? now.transform * glm::inverse(before) : mat4(1),
                 rigid});
        } else if (moved[i]) {
            add({.swept = now.bounds});
        }
        last += was_there ? 1 : 0;
    }
    for (; last < placed_.size(); ++last) {
        add({.swept = bounds_now(placed_[last])});
    }
    placed_.clear();
    placed_.reserve(scene.instances.size());
    for (const Instance& instance : scene.instances) {
        placed_.push_back({instance.id, instance.mesh, instance.bounds, instance.transform});
    }
    origin_ = scene.origin;
}

void SweptBoxes::set_carries(const gpu::Program& program, float margin) const {
    std::vector<vec4> lower, upper, rows;
    for (const Mover& mover : movers_) {
        if (mover.rigid) {
            lower.emplace_back(mover.before.lower - margin, 0);
            upper.emplace_back(mover.before.upper + margin, 0);
            const mat4 transposed = glm::transpose(mover.carry);
            rows.insert(rows.end(), {transposed[0], transposed[1], transposed[2]});
        }
    }
    program.set("carry_count", static_cast<int>(lower.size()));
    if (!lower.empty()) {
        program.set("carry_lower", lower);
        program.set("carry_upper", upper);
        program.set("carry_rows", rows);
    }
}

}  // namespace lanthorn::gi
