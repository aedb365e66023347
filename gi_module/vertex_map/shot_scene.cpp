#include "lanthorn/vertex_map/shot_scene.h"

#include <algorithm>

#include "lanthorn/render/coarse_shapes.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

namespace {

using reference::ReducedShape;

// The coarsest within `most`; null: none.
std::shared_ptr<const ReducedShape> coarsest(const InstanceShape& shape, bool textured, float most) {
    std::shared_ptr<ReducedShape> result;
    for (const render::CoarseLevel& level : render::coarser_levels(shape, textured)) {
        if (level.error > most) {
            break;
        }
        result = std::make_shared<ReducedShape>();
        result->vertices = level.indices;
        std::ranges::sort(result->vertices);
        result->vertices.erase(std::unique(result->vertices.begin(), result->vertices.end()),
                               result->vertices.end());
        for (const std::uint32_t index : level.indices) {
            const auto at = std::ranges::lower_bound(result->vertices, index);
            result->indices.push_back(static_cast<std::uint32_t>(at - result->vertices.begin()));
        }
        result->error = level.error;
    }
    return result;
}

}  // namespace

void ShotScene::clear() {
    sources_ = {};
    scene_.reset();
    materials_.reset();
    shapes_.clear();
}

reference::ReducedShapes ShotScene::reduced(const FrameScene& scene, float simplify) {
    if (simplify != simplify_) {
        shapes_.clear();
        simplify_ = simplify;
    }
    if (!(simplify > 0)) {
        return {};
    }
    for (auto& [topology, coarse] : shapes_) {
        coarse.used = false;
    }
    reference::ReducedShapes result(scene.instances.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Material& material = scene.material(instance);
        if (material.emits()) {
            continue;
        }
        const InstanceShape posed(scene, instance);
        const RefinedTopology* refined = posed.deformed() ? posed.deformed()->refined.get() : nullptr;
        const auto [at, fresh] =
            shapes_.try_emplace(refined != nullptr ? Topology(refined->serial, 0)
                                                   : Topology(0, scene.mesh_version(instance).any));
        at->second.used = true;
        if (fresh) {
            const auto textures = material.textures();
            const bool textured = std::ranges::any_of(textures, [](const auto* t) { return t->present(); });
            at->second.shape = coarsest(refined != nullptr ? posed : InstanceShape(scene.mesh(instance)),
                                        textured, simplify);
        }
        result[i] = at->second.shape;
    }
    std::erase_if(shapes_, [](const auto& entry) { return !entry.second.used; });
    return result;
}

bool ShotScene::follow(const FrameScene& scene, float simplify) {
    const SceneChanges& changes = scene.changes;
    const bool materials_changed = changes.assets || changes.emission || !changes.painted.empty();
    if (!materials_ || materials_changed) {
        materials_.emplace(*scene.assets);
    }
    const bool other_shapes = simplify != simplify_;
    const reference::ReducedShapes shapes = reduced(scene, simplify);
    const bool followed = scene_ && scene_->follow(scene, *materials_, shapes);
    if (!followed) {
        scene_.emplace(scene, *materials_, reference::Structure::moving, shapes);
        ++builds_;
    }
    const bool changed = !followed || other_shapes || materials_changed || changes.geometry || changes.lights;
    if (changed) {
        sources_ = PhotonSources(*scene_, *materials_, false);
    }
    return changed;
}

std::uint64_t ShotScene::triangles() const {
    std::uint64_t sum = 0;
    for (const reference::TraceInstance& instance : scene_->instances()) {
        sum += instance.triangle_places;
    }
    return sum;
}

}  // namespace lanthorn::gi
