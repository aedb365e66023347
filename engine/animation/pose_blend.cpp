#include "engine/animation/pose_blend.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>

#include "engine/animation/key_sampler.h"
#include "engine/animation/root_motion.h"

namespace lanthorn {
namespace {

using Target = PlayerBinding::Target;

double weight_of(const AnimationLayer& layer) {
    return std::max(finite_or_zero(layer.weight), 0.0);
}

const AnimationClip* clip_of(const PlayerBinding& binding, const AnimationLayer& layer) {
    return layer.clip < binding.clips->size() ? &(*binding.clips)[layer.clip] : nullptr;
}

void find_targets(PlayerBinding& binding) {
    std::map<std::pair<std::uint32_t, AnimationPath>, Target> found;
    for (const AnimationClip& clip : *binding.clips) {
        for (const AnimationChannel& channel : clip.channels) {
            Target& target =
                found.try_emplace({channel.node, channel.path}, Target{channel.node, channel.path, 0, 0})
                    .first->second;
            target.width = std::max(target.width, channel.width);
        }
    }
    binding.targets.clear();
    std::map<std::pair<std::uint32_t, AnimationPath>, std::uint32_t> place;
    std::uint32_t numbers = 0;
    std::uint32_t widest = 0;
    for (auto& [key, target] : found) {
        place[key] = static_cast<std::uint32_t>(binding.targets.size());
        target.first = numbers;
        numbers += target.width;
        widest = std::max(widest, target.width);
        binding.targets.push_back(target);
    }
    binding.targets_of.assign(binding.clips->size(), {});
    for (std::size_t c = 0; c < binding.clips->size(); ++c) {
        for (const AnimationChannel& channel : (*binding.clips)[c].channels) {
            binding.targets_of[c].push_back(place.at({channel.node, channel.path}));
        }
    }
    binding.rest.assign(numbers, 0.0);
    binding.pose.assign(numbers, 0.0);
    binding.scratch.assign(widest, 0.0);
}

void take_rest(PlayerBinding& binding, const Animator::Poses& poses) {
    for (const Target& target : binding.targets) {
        double* rest = binding.rest.data() + target.first;
        const ecs::Entity entity =
            target.node < binding.nodes.size() ? binding.nodes[target.node] : ecs::kNullEntity;
        if (target.path == AnimationPath::weights) {
            const MorphWeights* weights = poses.try_get<MorphWeights>(entity);
            for (std::size_t i = 0;
                 weights && i < std::min<std::size_t>(target.width, weights->weights.size()); ++i) {
                rest[i] = weights->weights[i];
            }
            continue;
        }
        const LocalTransform* local = poses.try_get<LocalTransform>(entity);
        const Transform transform = local ? local->value : Transform{};
        if (target.path == AnimationPath::rotation) {
            const quat& q = transform.rotation;
            const std::array<double, 4> values = {q.x, q.y, q.z, q.w};
            std::copy(values.begin(), values.end(), rest);
        } else {
            const dvec3 v =
                target.path == AnimationPath::scale ? dvec3(transform.scale) : transform.translation;
            for (int i = 0; i < 3; ++i) {
                rest[i] = v[i];
            }
        }
    }
}

// The rest pose of a node as a motion.
RigidMotion rest_of(const PlayerBinding& binding, std::uint32_t node) {
    RigidMotion rest;
    for (const Target& target : binding.targets) {
        const double* v = binding.rest.data() + target.first;
        if (target.node != node) {
            continue;
        }
        if (target.path == AnimationPath::translation) {
            rest.translation = {v[0], v[1], v[2]};
        }
        if (target.path == AnimationPath::rotation) {
            rest.turn = {v[3], v[0], v[1], v[2]};
        }
    }
    return rest;
}

// Adds weight * value; rotations on the side of the sum so far.
void add(const Target& target, double weight, const double* value, double* sum) {
    double signed_weight = weight;
    if (target.path == AnimationPath::rotation) {
        const double along = sum[0] * value[0] + sum[1] * value[1] + sum[2] * value[2] + sum[3] * value[3];
        if (along < 0) {
            signed_weight = -weight;
        }
    }
    for (std::uint32_t i = 0; i < target.width; ++i) {
        sum[i] += signed_weight * value[i];
    }
}

void advance_fade(AnimationLayer& layer, double seconds) {
    const double left = finite_or_zero(layer.fade_seconds);
    if (!(left > 0)) {
        return;
    }
    if (seconds >= left) {
        layer.weight = layer.fade_to;
        layer.fade_seconds = 0;
        return;
    }
    layer.weight += (layer.fade_to - layer.weight) * (seconds / left);
    layer.fade_seconds = left - seconds;
}

// The sum of the layers' weights, of those that have a clip.
double total_weight(const AnimationPlayer& player) {
    double sum = 0;
    for (const AnimationLayer& layer : player.layers) {
        if (clip_of(player.binding, layer)) {
            sum += weight_of(layer);
        }
    }
    return sum;
}

// Moves the layer on; returns its time before.
double advance_time(AnimationLayer& layer, double seconds, double duration) {
    const double before = finite_or_zero(layer.time);
    layer.time = before + finite_or_zero(finite_or_zero(layer.speed) * seconds);
    if (layer.loop == LoopMode::once) {
        layer.time = std::clamp(layer.time, 0.0, duration);
    }
    return before;
}

// Puts the root's place without its motion in place of what was sampled.
void remove_motion(const AnimationPlayer& player, const AnimationClip& clip, double time,
                   const Target& target, std::vector<double>& value) {
    const RigidMotion still =
        without_motion(clip, player.root, rest_of(player.binding, player.root.node), time);
    if (target.path == AnimationPath::translation) {
        for (int i = 0; i < 3; ++i) {
            value[static_cast<std::size_t>(i)] = still.translation[i];
        }
    } else if (target.path == AnimationPath::rotation) {
        value[0] = still.turn.x;
        value[1] = still.turn.y;
        value[2] = still.turn.z;
        value[3] = still.turn.w;
    }
}

void add_layer(AnimationPlayer& player, AnimationLayer& layer) {
    PlayerBinding& binding = player.binding;
    const AnimationClip* clip = clip_of(binding, layer);
    if (!clip) {
        return;
    }
    const double weight = weight_of(layer);
    const double time = clip_moment(layer.loop, finite_or_zero(layer.time), clip->duration).time;
    if (layer.hints.size() != clip->channels.size()) {
        layer.hints.assign(clip->channels.size(), 0);
    }
    const bool without_root = player.root.node != kNone && player.root.remove;
    for (std::size_t c = 0; c < clip->channels.size(); ++c) {
        Target& target = binding.targets[binding.targets_of[layer.clip][c]];
        target.moves = true;
        if (weight == 0) {
            continue;
        }
        const AnimationChannel& channel = clip->channels[c];
        // A clip of another width than the widest leaves the rest at 0.
        std::fill(binding.scratch.begin() + channel.width, binding.scratch.end(), 0.0);
        sample(channel, time, layer.hints[c], std::span(binding.scratch).first(channel.width));
        if (without_root && target.node == player.root.node) {
            remove_motion(player, *clip, time, target, binding.scratch);
        }
        add(target, weight, binding.scratch.data(), binding.pose.data() + target.first);
        target.weight += weight;
    }
}

void finish(PlayerBinding& binding, const Target& target, double total) {
    double* pose = binding.pose.data() + target.first;
    const double* rest = binding.rest.data() + target.first;
    const double whole = std::max(total, 1.0);
    const double rest_weight = target.moves ? std::max(whole - target.weight, 0.0) : whole;
    if (rest_weight > 0) {
        add(target, rest_weight, rest, pose);
    }
    double scale = 1 / whole;
    if (target.path == AnimationPath::rotation) {
        const double length =
            std::sqrt(pose[0] * pose[0] + pose[1] * pose[1] + pose[2] * pose[2] + pose[3] * pose[3]);
        if (!(length > 1e-9 * whole)) {  // opposite rotations that cancel out
            std::copy_n(rest, 4, pose);
            return;
        }
        scale = 1 / length;
    }
    for (std::uint32_t i = 0; i < target.width; ++i) {
        pose[i] *= scale;
    }
}

}  // namespace

void bind(AnimationPlayer& player, const AnimationSet& set, const Animator::Poses& poses) {
    PlayerBinding& binding = player.binding;
    if (binding.clips == set.clips && binding.nodes == set.nodes) {
        return;
    }
    assert(set.clips);
    binding.clips = set.clips;
    binding.nodes = set.nodes;
    find_targets(binding);
    take_rest(binding, poses);
}

void advance(AnimationPlayer& player, double seconds) {
    const double step = std::max(finite_or_zero(seconds), 0.0);
    RootMotion& root = player.root;
    const bool moves = root.node != kNone;
    const RigidMotion rest = moves ? rest_of(player.binding, root.node) : RigidMotion{};
    dvec3 carried(0);
    glm::dquat turned(0, 0, 0, 0);
    double weights = 0;
    for (AnimationLayer& layer : player.layers) {
        advance_fade(layer, step);
        const AnimationClip* clip = clip_of(player.binding, layer);
        if (!clip) {
            continue;
        }
        const double before = advance_time(layer, step, clip->duration);
        const double weight = weight_of(layer);
        if (!moves || weight == 0) {
            continue;
        }
        RigidMotion motion = root_motion(*clip, root, rest, layer.loop, before, layer.time);
        if (glm::dot(motion.turn, turned) < 0) {
            motion.turn = -motion.turn;
        }
        carried += weight * motion.translation;
        turned += weight * motion.turn;
        weights += weight;
    }
    std::erase_if(player.layers,
                  [](const AnimationLayer& layer) { return layer.leaves_after && layer.fade_seconds == 0; });
    const double whole = std::max(weights, 1.0);
    if (turned.w < 0) {
        turned = -turned;
    }
    turned.w += whole - weights;
    root.translation = carried / whole;
    root.turn = weights > 0 ? quat(glm::normalize(turned)) : quat(1, 0, 0, 0);
}

void blend(AnimationPlayer& player) {
    PlayerBinding& binding = player.binding;
    for (Target& target : binding.targets) {
        target.moves = false;
        target.weight = 0;
    }
    std::fill(binding.pose.begin(), binding.pose.end(), 0.0);
    for (AnimationLayer& layer : player.layers) {
        add_layer(player, layer);
    }
    const double total = total_weight(player);
    for (const Target& target : binding.targets) {
        if (target.moves || target.owned) {
            finish(binding, target, total);
        }
    }
}

}  // namespace lanthorn
