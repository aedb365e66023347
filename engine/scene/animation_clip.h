// Key frames as glTF has them (glTF 2.0, 3.11), decoded to floats. Played by engine/animation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lanthorn {

enum class AnimationPath : std::uint8_t { translation, rotation, scale, weights };
enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

// The keys of one property of one node.
struct AnimationChannel {
    std::uint32_t node = 0;  // into SceneData::nodes
    AnimationPath path = AnimationPath::translation;
    Interpolation interpolation = Interpolation::linear;
    std::uint32_t width = 3;   // floats a value: 3, 4 (rotation, x y z w), or the number of morph targets
    std::vector<float> times;  // seconds, strictly increasing, at least one, finite
    std::vector<float>
        values;  // width a key; cubic_spline: in-tangent, value, out-tangent, width each; finite
};

struct AnimationClip {
    std::string name;
    float duration = 0;  // seconds: the last key of all
    std::vector<AnimationChannel> channels;
};

}  // namespace lanthorn
