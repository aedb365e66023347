#include "lanthorn/animation/animator.h"

#include <algorithm>

#include "engine/animation/pose_blend.h"

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

void write_weights(const Animator::Poses& poses, ecs::Entity entity, std::span<const double> pose,
                   const Animator::Overwritten* overwritten) {
    const MorphWeights* old = poses.try_get<MorphWeights>(entity);
    if (!old) {
        return;
    }
    const std::size_t count = std::min(pose.size(), old->weights.size());
    const bool same =
        std::equal(pose.begin(), pose.begin() + static_cast<std::ptrdiff_t>(count), old->weights.begin(),
                   [](double a, float b) { return static_cast<float>(a) == b; });
    if (same) {
        return;
    }
    const std::vector<float> before = overwritten ? old->weights : std::vector<float>();
    std::vector<float>& weights = poses.try_get_mut<MorphWeights>(entity)->weights;
    for (std::size_t i = 0; i < count; ++i) {
        weights[i] = static_cast<float>(pose[i]);
    }
    if (overwritten) {
        overwritten->weights(entity, before, weights);
    }
}

// Poses are told to `overwritten` unless it is null.
void write(const Animator::Poses& poses, PlayerBinding& binding, const Animator::Overwritten* overwritten) {
    std::vector<Target>& targets = binding.targets;
    for (std::size_t i = 0; i < targets.size();) {
        const std::uint32_t node = targets[i].node;
        const ecs::Entity entity = node < binding.nodes.size() ? binding.nodes[node] : ecs::kNullEntity;
        const LocalTransform* old = poses.try_get<LocalTransform>(entity);
        Transform local = old ? old->value : Transform{};
        for (; i < targets.size() && targets[i].node == node; ++i) {
            Target& target = targets[i];
            const bool writes = target.moves || target.owned;
            if (!overwritten) {  // else the simulation's own writing goes on from here
                target.owned = target.moves;
            }
            if (!writes) {
                continue;
            }
            const double* pose = binding.pose.data() + target.first;
            if (target.path == AnimationPath::weights) {
                write_weights(poses, entity, {pose, target.width}, overwritten);
            } else {
                put(local, target.path, pose);
            }
        }
        if (old && old->value != local) {
            if (overwritten) {
                overwritten->transform(entity, old->value, local);
            }
            poses.try_get_mut<LocalTransform>(entity)->value = local;
        }
    }
}

}  // namespace

void Animator::animate(ecs::World& world, double seconds, double clock) {
    animate(players_.in(world), Poses(world), seconds, clock);
}

void Animator::animate(const Players& players, const Poses& poses, double seconds, double clock) {
    players.each([&](AnimationPlayer& player, const AnimationSet& set) {
        if (!set.clips || player.layers.empty()) {
            return;
        }
        bind(player, set, poses);
        if (player.by_clock) {
            player.layers.front().time = clock;
        }
        advance(player, player.by_clock ? 0 : seconds);
        blend(player);
        write(poses, player.binding, nullptr);
    });
}

void Animator::show(const Players& players, const Poses& poses, double back, double clock,
                    const Overwritten& overwritten) {
    players.each([&](AnimationPlayer& player, const AnimationSet& set) {
        if (!set.clips || player.layers.empty()) {
            return;
        }
        if (player.binding.clips != set.clips) {
            AnimationPlayer preview = player;  // what is there now is no rest pose: a step decides on that
            bind(preview, set, poses);
            show(preview, poses, 0, clock, overwritten);
        } else if (player.by_clock || back > 0) {
            show(player, poses, back, clock, overwritten);
        }
    });
}

void Animator::show(AnimationPlayer& player, const Poses& poses, double back, double clock,
                    const Overwritten& overwritten) {
    times_.clear();
    for (AnimationLayer& layer : player.layers) {
        times_.push_back(layer.time);
        layer.time -= player.by_clock ? 0 : back * layer.speed;
    }
    if (player.by_clock) {
        player.layers.front().time = clock;
    }
    blend(player);
    write(poses, player.binding, &overwritten);
    for (std::size_t i = 0; i < times_.size(); ++i) {
        player.layers[i].time = times_[i];
    }
}

void animate(ecs::World& world, double seconds) {
    Animator().animate(world, seconds);
}

}  // namespace lanthorn
