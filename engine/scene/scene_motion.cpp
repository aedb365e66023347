#include "lanthorn/scene/scene_motion.h"

#include <tuple>
#include <utility>

namespace lanthorn {

// There is nothing to compare with.
void SceneMotion::stand_still() {
    restarted_ = changed_ = true;
    left_.clear();
    rested_.clear();
    moving_.clear();
    painted_.clear();
    for (Known& known : known_) {
        known.state = State::still;
    }
}

void SceneMotion::leave(const Known& before) {
    if (before.state != State::moving) {
        left_.push_back(before.bounds);
    }
    changed_ = true;
}

void SceneMotion::compare(const FrameScene& scene) {
    const bool next = scene.frame == last_frame_ || scene.frame == last_frame_ + 1;
    last_frame_ = scene.frame;
    left_.clear();
    for (const std::uint32_t i : std::exchange(rested_, {})) {
        known_[i].state = State::still;
    }
    painted_.clear();
    const bool first = serial_ == 0 || scene.origin != origin_;
    const bool same_assets = scene.assets->serial == std::exchange(serial_, scene.assets->serial);
    origin_ = scene.origin;
    restarted_ = changed_ = false;
    if (next && !first && same_assets && !scene.changes.geometry && !any_moving() &&
        known_.size() == scene.instances.size()) {
        return;
    }
    moving_.clear();
    const std::vector<Known> last = std::exchange(known_, {});
    known_.reserve(scene.instances.size());
    bool any_left = false;
    auto before = last.begin();
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const std::tuple key(instance.id, instance.mesh);
        for (; before != last.end() && std::tuple(before->id, before->mesh) < key; ++before) {
            leave(*before);
        }
        const AssetVersion<Material>& material = scene.material_version(instance);
        Known& now = known_.emplace_back(Known{
            instance.id, instance.mesh, instance.version, scene.mesh_version(instance).any, material.surface,
            material.kept(scene.mesh(instance).material), instance.transform, instance.bounds, State::still});
        if (before != last.end() && std::tuple(before->id, before->mesh) == key) {
            if (!before->same_shape(now)) {
                leave(*before);
                now.state = State::moving;
            } else if (before->state == State::moving) {
                now.state = instance.is_static ? State::rested : State::moving;
            }
            if (before->kept != now.kept) {
                painted_.push_back(i);
                changed_ = true;
            }
            any_left = true;
            ++before;
        } else {
            now.state = State::moving;
            changed_ = true;
        }
        if (now.state == State::moving) {
            moving_.push_back(i);
        } else if (now.state == State::rested) {
            rested_.push_back(i);
        }
    }
    for (; before != last.end(); ++before) {
        leave(*before);
    }
    if (first || (!any_left && !known_.empty())) {
        stand_still();
    }
}

}  // namespace lanthorn
