#include "gi_module/shared/rays/ray_shapes.h"

#include <algorithm>
#include <vector>

#include "engine/render/coarse_shapes.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

using reference::ReducedShape;

std::shared_ptr<const ReducedShape> reduced_shape(const render::CoarseLevel& level) {
    auto shape = std::make_shared<ReducedShape>();
    shape->vertices = level.indices;
    std::ranges::sort(shape->vertices);
    shape->vertices.erase(std::unique(shape->vertices.begin(), shape->vertices.end()), shape->vertices.end());
    shape->indices.reserve(level.indices.size());
    for (const std::uint32_t index : level.indices) {
        shape->indices.push_back(static_cast<std::uint32_t>(std::ranges::lower_bound(shape->vertices, index) -
                                                            shape->vertices.begin()));
    }
    shape->error = level.error;
    return shape;
}

const RayShapes::Levels& RayShapes::levels_of(const FrameScene& scene, const Instance& instance) {
    const InstanceShape posed(scene, instance);
    const RefinedTopology* refined = posed.deformed() ? posed.deformed()->refined.get() : nullptr;
    const auto [at, fresh] = levels_.try_emplace(
        refined != nullptr ? Topology(refined->serial, 0, 0)
                           : Topology(0, instance.mesh, scene.mesh_version(instance).any));
    Levels& levels = at->second;
    levels.used = true;
    if (fresh) {
        const auto textures = scene.material(instance).textures();
        const bool textured = std::ranges::any_of(textures, [](const auto* t) { return t->present(); });
        // Of the mesh's own triangles the bind pose decides, not the first one that is seen.
        const InstanceShape shape = refined != nullptr ? posed : InstanceShape(scene.mesh(instance));
        for (const render::CoarseLevel& level : render::coarser_levels(shape, textured)) {
            levels.finer_first.push_back(reduced_shape(level));
        }
    }
    return levels;
}

reference::ReducedShapes RayShapes::follow(const FrameScene& scene) {
    std::vector<bool> arrived(scene.instances.size(), false);
    for (const std::uint32_t i : scene.changes.arrived) {
        arrived[i] = true;
    }
    for (const std::uint32_t i : scene.changes.moved) {
        if (!arrived[i] && !scene.changes.replaced) {
            moved_.emplace(scene.instances[i].id, scene.instances[i].mesh);
        }
    }
    for (auto& [topology, levels] : levels_) {
        levels.used = false;
    }
    reference::ReducedShapes shapes(scene.instances.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Instance& instance = scene.instances[i];
        if (instance.deformed == Instance::kNotDeformed && !moved_.contains({instance.id, instance.mesh})) {
            continue;
        }
        const float most = std::min(kError, kErrorOfScene * scene.diagonal() / instance.bounds.diagonal());
        for (const auto& level : levels_of(scene, instance).finer_first) {
            if (level->error <= most) {
                shapes[i] = level;
            }
        }
    }
    std::erase_if(levels_, [](const auto& entry) { return !entry.second.used; });
    return shapes;
}

}  // namespace lanthorn::gi
