#include "gi_module/techniques/splat/splat_surfaces.h"

#include <algorithm>
#include <utility>

#include "gi_module/shared/photons/copies.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

std::shared_ptr<const SurfaceParts> SplatSurfaces::parts_of(const FrameScene& scene,
                                                            const Instance& instance) {
    const InstanceShape shape(scene, instance);
    const bool refined = shape.deformed() != nullptr && shape.deformed()->refined;
    std::weak_ptr<const SurfaceParts>& known =
        parts_[{instance.mesh, scene.assets->meshes.version(instance.mesh).any,
                refined ? shape.deformed()->refined->serial : 0}];
    if (auto parts = known.lock()) {
        return parts;
    }
    std::vector<vec3> positions(shape.vertex_count());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        positions[v] = shape.position(v);
    }
    auto parts = std::make_shared<const SurfaceParts>(surface_parts(positions, shape.indices()));
    known = parts;
    return parts;
}

void SplatSurfaces::place(const FrameScene& scene, const Instance& instance, Placed& placed) {
    const InstanceShape shape(scene, instance);
    std::vector<vec3> positions(shape.vertex_count());
    for (std::size_t v = 0; v < positions.size(); ++v) {
        positions[v] = vec3(instance.transform * vec4(shape.position(v), 1));
    }
    std::vector<std::vector<std::array<vec3, 3>>> triangles(placed.parts->count);
    const auto indices = shape.indices();
    for (std::size_t t = 0; t < placed.parts->of_triangle.size(); ++t) {
        if (placed.parts->first_copy[t] != t) {
            continue;
        }
        triangles[placed.parts->of_triangle[t]].push_back(
            {positions[indices[3 * t]], positions[indices[3 * t + 1]], positions[indices[3 * t + 2]]});
    }
    placed.trees.clear();
    for (auto& part : triangles) {
        placed.trees.emplace_back(std::move(part));
    }
}

void SplatSurfaces::follow(const FrameScene& scene, reference::TileWorkers& workers) {
    std::vector<Placed> before = std::exchange(placed_, {});
    std::map<std::pair<std::uint32_t, std::uint32_t>, Placed*> by_id;
    for (Placed& p : before) {
        by_id[{p.id, std::get<0>(p.topology)}] = &p;
    }
    placed_.resize(scene.instances.size());
    std::vector<std::size_t> moved;
    count_ = 0;
    const std::vector<std::uint32_t> first = first_of_copies(scene);
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const InstanceShape shape(scene, instance);
        const bool refined = shape.deformed() != nullptr && shape.deformed()->refined;
        const Topology topology{instance.mesh, scene.assets->meshes.version(instance.mesh).any,
                                refined ? shape.deformed()->refined->serial : 0};
        const auto found = by_id.find({instance.id, instance.mesh});
        Placed& now = placed_[i];
        if (found != by_id.end() && found->second->parts && found->second->topology == topology) {
            now = std::move(*found->second);
        } else {
            now.parts = parts_of(scene, instance);
        }
        if (now.trees.size() != now.parts->count || now.transform != instance.transform ||
            now.version != instance.version) {
            moved.push_back(i);
        }
        now.id = instance.id;
        now.topology = topology;
        now.transform = instance.transform;
        now.version = instance.version;
        // Copies are one surface.
        now.first = first[i] == i ? static_cast<std::uint32_t>(count_) : placed_[first[i]].first;
        count_ += first[i] == i ? now.parts->count : 0;
    }
    workers.run(moved.size(),
                [&](std::size_t k) { place(scene, scene.instances[moved[k]], placed_[moved[k]]); });
    places_.clear();
    for (std::uint32_t i = 0; i < placed_.size(); ++i) {
        for (std::uint32_t part = 0; first[i] == i && part < placed_[i].parts->count; ++part) {
            places_.push_back({i, part});
        }
    }
    std::erase_if(parts_, [](const auto& entry) { return entry.second.expired(); });
}

}  // namespace lanthorn::gi
