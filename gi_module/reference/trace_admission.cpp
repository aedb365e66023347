// Instances of a TraceScene that come and go.
#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "gi_module/reference/trace_filter.h"

namespace lanthorn::reference {

bool TraceScene::admit(const FrameScene& scene) {
    if (scene.changes.replaced || scene.origin != origin_) {
        return false;
    }
    const auto same_id = [](const TraceInstance& was, const Instance& is) { return was.id == is.id; };
    if (scene.changes.arrived.empty() && std::ranges::equal(instances_, scene.instances, same_id)) {
        return true;
    }
    std::unordered_map<std::uint32_t, std::size_t> before;
    for (std::size_t i = 0; i < instances_.size(); ++i) {
        before.emplace(instances_[i].id, i);
    }
    std::vector<bool> arrived(scene.instances.size(), false);
    for (const std::uint32_t i : scene.changes.arrived) {
        arrived[i] = true;
    }
    std::vector<Shape> shapes(scene.instances.size());
    std::vector<TraceInstance> instances(scene.instances.size());
    for (std::size_t i = 0; i < instances.size(); ++i) {
        instances[i].id = scene.instances[i].id;
        const auto was = before.find(instances[i].id);
        if (arrived[i] || was == before.end()) {
            continue;
        }
        shapes[i] = std::move(shapes_[was->second]);
        instances[i] = std::move(instances_[was->second]);
        shapes[i].filter->instance = static_cast<std::uint32_t>(i);
        instance_of_[shapes[i].geometry] = static_cast<std::uint32_t>(i);
        before.erase(was);
    }
    for (const auto& [id, i] : before) {
        remove(shapes_[i], instances_[i]);
    }
    shapes_ = std::move(shapes);
    instances_ = std::move(instances);
    admitted_ = true;
    return true;
}

void TraceScene::remove(const Shape& shape, const TraceInstance& instance) {
    if (shape.geometry != kNoGeometry) {
        rtcDetachGeometry(scene_, shape.geometry);
        unused_.push_back(shape.geometry);
    }
    places_.give_back(instance.first_triangle, instance.triangle_places);
}

std::uint32_t TraceScene::place_for(std::uint32_t count) {
    std::optional<std::size_t> first = places_.take(count);
    if (!first) {
        triangles_.resize(triangles_.size() + count);
        places_.grow(triangles_.size());
        first = places_.take(count);
    }
    return static_cast<std::uint32_t>(*first);
}

}  // namespace lanthorn::reference
