#include "lanthorn/coarse/followed_scene.h"

namespace lanthorn::gi {

void FollowedScene::clear() {
    scene_.reset();
    materials_.reset();
}

bool FollowedScene::follow(const FrameScene& scene) {
    const SceneChanges& changes = scene.changes;
    const bool materials_changed = changes.assets || changes.emission || !changes.painted.empty();
    if (!materials_ || materials_changed) {
        materials_.emplace(*scene.assets);
    }
    const bool followed = scene_ && scene_->follow(scene, *materials_);
    if (!followed) {
        scene_.emplace(scene, *materials_, reference::Structure::moving);
        ++builds_;
    }
    return !followed || materials_changed || changes.geometry;
}

}  // namespace lanthorn::gi
