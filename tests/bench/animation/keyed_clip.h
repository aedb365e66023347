// A clip that keys translation, rotation and scale of every joint 30 times a second for 4 s.
#pragma once

#include <cmath>

#include "lanthorn/scene/animation_clip.h"

namespace animation_bench {

using namespace lanthorn;

constexpr std::uint32_t kKeys = 121;

inline float wave(std::uint32_t joint, std::uint32_t key, std::uint32_t which) {
    return std::sin(0.1f * static_cast<float>(key) + static_cast<float>(joint * 4 + which));
}

inline AnimationChannel keyed(std::uint32_t joint, AnimationPath path, Interpolation interpolation) {
    AnimationChannel c;
    c.node = joint;
    c.path = path;
    c.interpolation = interpolation;
    c.width = path == AnimationPath::rotation ? 4 : 3;
    const std::uint32_t parts = interpolation == Interpolation::cubic_spline ? 3 : 1;
    for (std::uint32_t k = 0; k < kKeys; ++k) {
        c.times.push_back(static_cast<float>(k) / 30);
        for (std::uint32_t p = 0; p < parts; ++p) {
            const float angle = wave(joint, k, p);
            if (path == AnimationPath::rotation) {
                c.values.insert(c.values.end(), {std::sin(angle), 0, 0, std::cos(angle)});
            } else {
                c.values.insert(c.values.end(), {angle, wave(joint, k, p + 1), wave(joint, k, p + 2)});
            }
        }
    }
    return c;
}

inline AnimationClip keyed_clip(std::uint32_t joints, Interpolation interpolation) {
    AnimationClip clip;
    clip.duration = static_cast<float>(kKeys - 1) / 30;
    for (std::uint32_t j = 0; j < joints; ++j) {
        for (const auto path : {AnimationPath::translation, AnimationPath::rotation, AnimationPath::scale}) {
            clip.channels.push_back(keyed(j, path, interpolation));
        }
    }
    return clip;
}

}  // namespace animation_bench
