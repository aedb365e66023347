// Small clips and figures for the tests of this folder.
#pragma once

#include <array>
#include <vector>

#include "engine/animation/key_sampler.h"
#include "lanthorn/animation/animator.h"
#include "lanthorn/scene/spawn.h"

namespace animation_test {

using namespace lanthorn;

inline AnimationChannel channel(AnimationPath path, Interpolation interpolation, std::vector<float> times,
                                std::vector<float> values, std::uint32_t node = 0) {
    AnimationChannel c;
    c.node = node;
    c.path = path;
    c.interpolation = interpolation;
    c.width = path == AnimationPath::rotation ? 4 : path == AnimationPath::weights ? 1 : 3;
    c.times = std::move(times);
    c.values = std::move(values);
    return c;
}

inline AnimationClip clip(std::vector<AnimationChannel> channels) {
    AnimationClip c;
    for (const AnimationChannel& ch : channels) {
        c.duration = std::max(c.duration, ch.times.back());
    }
    c.channels = std::move(channels);
    return c;
}

// Along +X at one metre a second for `seconds`.
inline AnimationClip walk(float seconds = 2, std::uint32_t node = 0) {
    return clip({channel(AnimationPath::translation, Interpolation::linear, {0, seconds},
                         {0, 0, 0, seconds, 0, 0}, node)});
}

inline std::vector<double> value_at(const AnimationChannel& c, double time) {
    std::vector<double> value(c.width);
    std::uint32_t hint = 0;
    sample(c, time, hint, value);
    return value;
}

// Rotation about +Z by `degrees`, x y z w.
inline std::array<float, 4> about_z(double degrees) {
    const double half = degrees * 3.14159265358979323846 / 360;
    return {0, 0, static_cast<float>(std::sin(half)), static_cast<float>(std::cos(half))};
}

// `count` nodes at their own places, whose set has `clips`.
struct Figure {
    explicit Figure(std::vector<AnimationClip> clips, std::size_t count = 2) {
        SceneData scene;
        scene.nodes.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            scene.nodes[i].local.translation.y = static_cast<double>(i);
        }
        scene.animations = std::move(clips);
        nodes = spawn(world, std::move(scene));
        holder = world.query<ecs::With<AnimationSet>>().single_entity();
        world.add(holder, AnimationPlayer{});
    }
    AnimationPlayer& player() { return world.get_mut<AnimationPlayer>(holder); }
    const AnimationSet& set() { return world.get<AnimationSet>(holder); }
    void step(double seconds) { animator.animate(world, seconds); }
    const Transform& local(std::size_t node = 0) { return world.get<LocalTransform>(nodes[node]).value; }
    double x(std::size_t node = 0) { return local(node).translation.x; }

    ecs::World world;
    std::vector<ecs::Entity> nodes;
    ecs::Entity holder;
    Animator animator;
};

}  // namespace animation_test
