#include "gi_module/techniques/vertex-map/shot_scene.h"

#include <algorithm>

#include "engine/render/coarse_shapes.h"
#include "gi_module/shared/rays/ray_shapes.h"
#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

namespace {

// The coarsest within `most`; null: none.
std::shared_ptr<const reference::ReducedShape> coarsest(const InstanceShape& shape, bool textured,
                                                        float most) {
    const std::vector<render::CoarseLevel> levels = render::coarser_levels(shape, textured);
    const auto beyond = std::ranges::find_if(levels, [&](const auto& l) { return l.error > most; });
    return beyond == levels.begin() ? nullptr : reduced_shape(*(beyond - 1));
}

}  // namespace

void ShotScene::clear() {
    sources_ = {};
    scene_.clear();
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
    const bool other_shapes = simplify != simplify_;
    const bool other_surfaces = scene_.follow(scene, reduced(scene, simplify));
    const bool changed = other_surfaces || other_shapes || scene.changes.lights;
    if (changed) {
        sources_ = PhotonSources(scene_.scene(), scene_.materials(), &scene_.pieces());
    }
    return changed;
}

std::uint64_t ShotScene::triangles() const {
    std::uint64_t sum = 0;
    for (const reference::TraceInstance& instance : scene_.scene().instances()) {
        sum += instance.triangle_places;
    }
    return sum;
}

}  // namespace lanthorn::gi
