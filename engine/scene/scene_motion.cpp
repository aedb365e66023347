#include "lanthorn/scene/scene_motion.h"

#include <tuple>
#include <utility>

namespace lanthorn {

void SceneMotion::forget_if_other(const FrameScene& scene) {
    restarted_ = scene.assets->serial != serial_ || scene.origin != origin_;
    if (restarted_) {
        known_.clear();
        serial_ = scene.assets->serial;
        origin_ = scene.origin;
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
    forget_if_other(scene);
    changed_ = restarted_;
    if (next && !restarted_ && !scene.changes.geometry && !any_moving() &&
        known_.size() == scene.instances.size()) {
        return;
    }
    moving_.clear();
    const std::vector<Known> last = std::exchange(known_, {});
    known_.reserve(scene.instances.size());
    auto before = last.begin();
    for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const std::tuple key(instance.id, instance.mesh);
        for (; before != last.end() && std::tuple(before->id, before->mesh) < key; ++before) {
            leave(*before);
        }
        Known& now = known_.emplace_back(Known{instance.id, instance.mesh, instance.version,
                                               instance.transform, instance.bounds, State::still});
        if (before != last.end() && std::tuple(before->id, before->mesh) == key) {
            if (!before->same_shape(now)) {
                leave(*before);
                now.state = State::moving;
            } else if (before->state == State::moving) {
                now.state = instance.is_static ? State::rested : State::moving;
            }
            ++before;
        } else if (!restarted_) {
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
}

}  // namespace lanthorn
