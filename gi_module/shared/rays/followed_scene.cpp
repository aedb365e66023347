#include "gi_module/shared/rays/followed_scene.h"

namespace lanthorn::gi {

void FollowedScene::clear() {
    scene_.reset();
    materials_.reset();
    pieces_ = {};
}

bool FollowedScene::follow(const FrameScene& scene, RayDetail detail) {
    return follow(scene, detail == RayDetail::coarser ? shapes_.follow(scene) : reference::ReducedShapes());
}

bool FollowedScene::follow(const FrameScene& scene, const reference::ReducedShapes& reduced) {
    const SceneChanges& changes = scene.changes;
    const bool materials_changed = changes.assets || changes.emission || !changes.painted.empty();
    if (!materials_ || materials_changed) {
        materials_.emplace(*scene.assets);
    }
    const bool followed = scene_ && scene_->admit(scene) && scene_->follow(scene, *materials_, reduced);
    if (!followed) {
        scene_.emplace(scene, *materials_, reference::Structure::moving, reduced);
        ++builds_;
    }
    return !followed || materials_changed || changes.geometry;
}

}  // namespace lanthorn::gi
