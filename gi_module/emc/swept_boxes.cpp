#include "lanthorn/gi/emc/swept_boxes.h"

#include <algorithm>
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

// Two of the boxes become one.
void merge_closest(std::vector<Aabb>& boxes) {
    std::size_t first = 0, second = 1;
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            const float growth = area(around(boxes[i], boxes[j])) - area(boxes[i]) - area(boxes[j]);
            if (growth < least) {
                least = growth;
                first = i;
                second = j;
            }
        }
    }
    boxes[first] = around(boxes[first], boxes[second]);
    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(second));
}

}  // namespace

void SweptBoxes::follow(const FrameScene& scene) {
    boxes_.clear();
    const auto add = [&](const Aabb& box) {
        if (!box.empty()) {
            boxes_.push_back(box);
        }
        if (boxes_.size() > kMost) {
            merge_closest(boxes_);
        }
    };
    const vec3 shift(origin_ - scene.origin);  // what was at p is now at p + shift
    const auto key = [](const auto& placed) { return std::pair(placed.id, placed.mesh); };
    std::vector<bool> moved(scene.instances.size(), false);
    for (const std::uint32_t i : scene.changes.moved) {
        moved[i] = true;
    }
    std::size_t last = 0;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& now = scene.instances[i];
        for (; last < placed_.size() && key(placed_[last]) < key(now); ++last) {
            add({placed_[last].bounds.lower + shift, placed_[last].bounds.upper + shift});  // it is gone
        }
        const bool was_there = last < placed_.size() && key(placed_[last]) == key(now);
        if (moved[i]) {
            Aabb swept = now.bounds;
            if (was_there) {
                swept.add({placed_[last].bounds.lower + shift, placed_[last].bounds.upper + shift});
            }
            add(swept);
        }
        last += was_there ? 1 : 0;
    }
    for (; last < placed_.size(); ++last) {
        add({placed_[last].bounds.lower + shift, placed_[last].bounds.upper + shift});
    }
    placed_.clear();
    placed_.reserve(scene.instances.size());
    for (const Instance& instance : scene.instances) {
        placed_.push_back({instance.id, instance.mesh, instance.bounds});
    }
    origin_ = scene.origin;
}

void SweptBoxes::set(const gpu::Program& program, float margin) const {
    program.set("box_count", static_cast<int>(boxes_.size()));
    if (boxes_.empty()) {
        return;
    }
    std::vector<vec4> lower, upper;
    for (const Aabb& box : boxes_) {
        lower.emplace_back(box.lower - margin, 0);
        upper.emplace_back(box.upper + margin, 0);
    }
    program.set("box_lower", lower);
    program.set("box_upper", upper);
}

}  // namespace lanthorn::gi
