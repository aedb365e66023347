#include "lanthorn/runtime/interpolation.h"

namespace lanthorn {

void declare_interpolation(ecs::Registry& registry) {
    using ecs::field;
    registry
        .component<Interpolated>(
            "interpolated", "shown between its last two poses",
            field("previous", &Interpolated::previous).transient().words("at the end of the step before"),
            field("current", &Interpolated::current).transient().words("at the end of the last step"),
            field("shown", &Interpolated::shown).transient().words("in the picture"),
            field("started", &Interpolated::started).transient().words("previous and current are there"),
            field("between", &Interpolated::between).transient().words("LocalTransform is what is shown"))
        .runtime()
        .not_in_extras();
}

Transform between(const Transform& from, const Transform& to, double share) {
    if (share <= 0 || from == to) {
        return from;
    }
    if (share >= 1) {
        return to;
    }
    const auto s = static_cast<float>(share);
    Transform result;
    result.translation = glm::mix(from.translation, to.translation, share);
    result.rotation = from.rotation == to.rotation ? to.rotation : glm::slerp(from.rotation, to.rotation, s);
    result.scale = glm::mix(from.scale, to.scale, s);
    return result;
}

void remember_pose(Interpolated& pose, const Transform& local) {
    pose.previous = pose.started ? pose.current : local;
    pose.current = local;
    pose.started = true;
    pose.between = false;
}

bool show_pose(Interpolated& pose, double blend, Transform& local) {
    const bool restored = restore_pose(pose, local);
    pose.shown = between(pose.previous, pose.current, blend);
    pose.between = pose.shown != pose.current;
    local = pose.shown;
    return restored || pose.between;
}

bool restore_pose(Interpolated& pose, Transform& local) {
    const bool was_between = std::exchange(pose.between, false);
    if (!pose.started || local != (was_between ? pose.shown : pose.current)) {
        pose.previous = pose.current = local;  // it jumped here
        pose.started = true;
        return false;
    }
    local = pose.current;
    return was_between;
}

namespace {

template <class Component, class Kept, class Value>
void put_back(const SimulatedPose::Poses& poses, std::vector<Kept>& all, Value Component::*member) {
    for (auto kept = all.rbegin(); kept != all.rend(); ++kept) {
        const Component* now = poses.try_get<Component>(kept->entity);
        if (now != nullptr && now->*member == kept->shown) {
            poses.try_get_mut<Component>(kept->entity)->*member = kept->simulated;
        }
    }
    all.clear();
}

}  // namespace

void SimulatedPose::restore(const Poses& poses) {
    put_back(poses, weights_, &MorphWeights::weights);
    put_back(poses, transforms_, &LocalTransform::value);
    put_back(poses, lights_, &LightComponent::light);
    put_back(poses, cameras_, &CameraComponent::camera);
}

}  // namespace lanthorn
