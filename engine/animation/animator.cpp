#include "lanthorn/animation/animator.h"

#include <algorithm>

#include "lanthorn/animation/pose_blend.h"

namespace lanthorn {
namespace {

using Target = PlayerBinding::Target;

void put(Transform& transform, AnimationPath path, const double* v) {
    if (path == AnimationPath::translation) {
        transform.translation = {v[0], v[1], v[2]};
    } else if (path == AnimationPath::scale) {
        transform.scale = vec3(v[0], v[1], v[2]);
    } else {
        transform.rotation = quat(static_cast<float>(v[3]), static_cast<float>(v[0]),
                                  static_cast<float>(v[1]), static_cast<float>(v[2]));
    }
}

void write_weights(ecs::World& world, ecs::Entity entity, std::span<const double> pose) {
    const MorphWeights* old = world.try_get<MorphWeights>(entity);
    if (!old) return;
    const std::size_t count = std::min(pose.size(), old->weights.size());
    const bool same =
        std::equal(pose.begin(), pose.begin() + static_cast<std::ptrdiff_t>(count), old->weights.begin(),
                   [](double a, float b) { return static_cast<float>(a) == b; });
    if (same) return;
    std::vector<float>& weights = world.try_get_mut<MorphWeights>(entity)->weights;
    for (std::size_t i = 0; i < count; ++i) weights[i] = static_cast<float>(pose[i]);
}

void write(ecs::World& world, PlayerBinding& binding) {
    std::vector<Target>& targets = binding.targets;
    for (std::size_t i = 0; i < targets.size();) {
        const std::uint32_t node = targets[i].node;
        const ecs::Entity entity = node < binding.nodes.size() ? binding.nodes[node] : ecs::kNullEntity;
        const LocalTransform* old = world.try_get<LocalTransform>(entity);
        Transform local = old ? old->value : Transform{};
        for (; i < targets.size() && targets[i].node == node; ++i) {
            Target& target = targets[i];
            const bool writes = target.moves || target.owned;
            target.owned = target.moves;
            if (!writes) continue;
            const double* pose = binding.pose.data() + target.first;
            if (target.path == AnimationPath::weights) {
                write_weights(world, entity, {pose, target.width});
            } else {
                put(local, target.path, pose);
            }
        }
        if (old && old->value != local) world.try_get_mut<LocalTransform>(entity)->value = local;
    }
}

}  // namespace

void Animator::animate(ecs::World& world, double seconds) {
    players_.in(world).each([&](AnimationPlayer& player, const AnimationSet& set) {
        if (!set.clips || player.layers.empty()) return;
        bind(player, set, world);
        advance(player, seconds);
        blend(player);
        write(world, player.binding);
    });
}

void animate(ecs::World& world, double seconds) {
    Animator().animate(world, seconds);
}

}  // namespace lanthorn
