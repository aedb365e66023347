#include "gi_module/techniques/emc/gather/swept_boxes.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

constexpr std::size_t kLimbs = 8;   // of a figure, at most
constexpr std::size_t kParts = 32;  // of a figure, at most, that are carried each for itself
// Movers in a frame, from which on nobody is carried by parts: nearly all of them become one with others.
constexpr std::size_t kCrowd = 4 * SweptBoxes::kMost;
constexpr float kMargin = 2e-5f;  // of EnvironmentMaps::extent(), against rounding

// The two whose boxes grow least by becoming one, and by how much.
struct Pair {
    std::size_t i = 0, j = 1;
    float growth = std::numeric_limits<float>::max();  // m^2
};

Pair closest(const std::vector<Aabb>& boxes) {
    Pair best;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size(); ++j) {
            const float growth = area(around(boxes[i], boxes[j])) - area(boxes[i]) - area(boxes[j]);
            if (growth < best.growth) {
                best = {i, j, growth};
            }
        }
    }
    return best;
}

void join(std::vector<Aabb>& boxes, const Pair& pair) {
    boxes[pair.i] = around(boxes[pair.i], boxes[pair.j]);
    boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(pair.j));
}

// Adds one, if it holds anything; then there are at most `most`.
void add_box(std::vector<Aabb>& boxes, const Aabb& box, std::size_t most) {
    if (!box.empty()) {
        boxes.push_back(box);
    }
    while (boxes.size() > most) {
        join(boxes, closest(boxes));
    }
}

// Boxes that one around both takes the place of without more surface.
void join_for_nothing(std::vector<Aabb>& boxes) {
    for (Pair next = closest(boxes); next.growth <= 0; next = closest(boxes)) {
        join(boxes, next);
    }
}

// One that carries nothing.
Mover swept_only(const Aabb& box) {
    Mover mover;
    mover.swept = box;
    return mover;
}

// Two of them become one, which carries nothing.
void merge_closest(std::vector<Mover>& movers) {
    std::vector<Aabb> boxes;
    std::ranges::transform(movers, std::back_inserter(boxes), &Mover::swept);
    const auto [i, j, growth] = closest(boxes);
    movers[i] = swept_only(around(boxes[i], boxes[j]));
    movers.erase(movers.begin() + static_cast<std::ptrdiff_t>(j));
}

}  // namespace

SweptBoxes::Swept SweptBoxes::sweep_limbs(const FrameScene& scene, const Instance& instance) {
    const Key key(instance.id, instance.mesh);
    const DeformedMesh* deformed =
        instance.deformed == Instance::kNotDeformed ? nullptr : &scene.deformed[instance.deformed];
    if (deformed == nullptr || !deformed->vertices) {
        figures_.erase(key);
        return {};
    }
    const std::vector<VertexFrame>& vertices = *deformed->vertices;
    const std::uint64_t topology = deformed->refined ? deformed->refined->serial : 0;
    const std::uint64_t mesh = scene.mesh_version(instance).any;
    Figure& figure = figures_[key];
    if (figure.topology != topology || figure.mesh != mesh || figure.vertices != vertices.size()) {
        const auto& indices = deformed->refined ? deformed->refined->indices : scene.mesh(instance).indices;
        figure = {topology,
                  mesh,
                  vertices.size(),
                  Limbs(vertices, indices, kLimbs),
                  {},
                  Limbs(vertices, indices, kParts),
                  nullptr,
                  mat4(1)};
    }
    const std::vector<Aabb> before =
        std::exchange(figure.boxes, figure.limbs.boxes(vertices, instance.transform));
    Swept swept;
    for (std::size_t i = 0; i < before.size(); ++i) {
        swept.limbs.push_back(around(before[i], figure.boxes[i]));
    }
    if (figure.before && scene.changes.moved.size() < kCrowd) {
        swept.parts =
            figure.parts.motions({*figure.before, figure.transform}, {vertices, instance.transform});
    }
    figure.before = deformed->vertices;
    figure.transform = instance.transform;
    return swept;
}

void SweptBoxes::follow(const FrameScene& scene, float local_length) {
    movers_.clear();
    parts_.clear();
    std::size_t count = 0;  // of movers
    const auto add = [&](const Mover& mover) {
        if (!mover.swept.empty()) {
            movers_.push_back(mover);
            ++count;
        }
        if (movers_.size() > kMost) {
            merge_closest(movers_);
        }
    };
    const vec3 shift(origin_ - scene.origin);  // what was at p is now at p + shift
    const auto bounds_now = [&](const Placed& placed) -> Aabb {
        return {placed.bounds.lower + shift, placed.bounds.upper + shift};
    };
    for (auto& [key, figure] : figures_) {
        for (Aabb& box : figure.boxes) {
            box = {box.lower + shift, box.upper + shift};
        }
        figure.transform[3] += vec4(shift, 0);
    }
    std::vector<bool> moved(scene.instances.size(), false);
    for (const std::uint32_t i : scene.changes.moved) {
        moved[i] = true;
    }
    boxes_.clear();           // what movers without limbs sweep
    std::vector<Aabb> limbs;  // what all limbs do
    const auto add_part = [&](std::vector<Aabb>& boxes, const Aabb& box, std::size_t most) {
        if (!box.empty()) {
            parts_.push_back(box);
        }
        add_box(boxes, box, most);
    };
    std::size_t last = 0;
    const auto gone = [&](const Placed& placed) {
        figures_.erase(placed.key);
        add(swept_only(bounds_now(placed)));
        add_part(boxes_, bounds_now(placed), kMost - 1);
    };
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& now = scene.instances[i];
        const Key key(now.id, now.mesh);
        for (; last < placed_.size() && placed_[last].key < key; ++last) {
            gone(placed_[last]);
        }
        const bool was_there = last < placed_.size() && placed_[last].key == key;
        if (moved[i]) {
            Mover mover = swept_only(now.bounds);
            if (was_there) {
                mat4 before = placed_[last].transform;
                before[3] += vec4(shift, 0);
                const bool rigid =
                    now.deformed == Instance::kNotDeformed && std::abs(glm::determinant(before)) > 0;
                const Aabb was = bounds_now(placed_[last]);
                mover = {was,
                         around(was, now.bounds),
                         rigid ? now.transform * glm::inverse(before) : mat4(1),
                         rigid,
                         {}};
            }
            Swept swept = sweep_limbs(scene, now);
            for (const Aabb& limb : swept.limbs) {
                add_part(limbs, limb, kMost);
            }
            if (swept.limbs.empty()) {
                add_part(boxes_, mover.swept, kMost - 1);
            }
            mover.limbs = std::move(swept.parts);
            add(mover);
        }
        last += was_there ? 1 : 0;
    }
    for (; last < placed_.size(); ++last) {
        gone(placed_[last]);
    }
    add_box(limbs, {}, kMost - boxes_.size());
    has_limbs_ = !limbs.empty();
    boxes_.insert(boxes_.end(), limbs.begin(), limbs.end());
    whole_.clear();
    for (const Mover& mover : movers_) {
        whole_.push_back(mover.swept);
    }
    if (has_limbs_) {
        join_for_nothing(whole_);
    }
    if (count <= kMost) {
        parts_.clear();
    }
    grid_.fill(parts_, kMargin * local_length);
    placed_.clear();
    placed_.reserve(scene.instances.size());
    for (const Instance& instance : scene.instances) {
        placed_.push_back({{instance.id, instance.mesh}, instance.bounds, instance.transform});
    }
    origin_ = scene.origin;
}

std::vector<std::vector<SweptBoxes::Carry>> SweptBoxes::carries() const {
    std::vector<std::vector<Carry>> result;
    for (const Mover& mover : movers_) {
        std::vector<Carry> parts;
        if (mover.rigid) {
            parts.push_back({mover.before, mover.carry});
        }
        for (const LimbMotion& limb : mover.limbs) {
            parts.push_back({limb.before, limb.carry, true});
        }
        if (!parts.empty()) {
            result.push_back(std::move(parts));
        }
    }
    return result;
}

}  // namespace lanthorn::gi
