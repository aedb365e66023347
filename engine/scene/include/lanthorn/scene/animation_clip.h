// Key frames as glTF has them (glTF 2.0, 3.11), decoded to floats. Played by engine/animation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lanthorn/scene/animated_property.h"

namespace lanthorn {

// What of a node a channel moves; weights: of morph targets, all together.
enum class AnimationPath : std::uint8_t { translation, rotation, scale, weights };
// Between two keys: the value of the first, a straight line (rotations: the shorter arc), or a Hermite
// spline.
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

// The keys of one property of a light, camera or material.
struct PropertyChannel {
    AnimatedProperty property = AnimatedProperty::light_intensity;
    std::uint32_t object = 0;          // into SceneData::lights, cameras or materials
    std::vector<std::uint32_t> nodes;  // into SceneData::nodes: those that show the light or camera
    PropertyValue rest{};              // what the file says without a clip
    AnimationChannel keys;             // of width_of(property); node and path say nothing
};

struct AnimationClip {
    std::string name;
    float duration = 0;  // seconds: the last key of all
    std::vector<AnimationChannel> channels;
    std::vector<PropertyChannel> properties;  // by owner, object, then property
};

}  // namespace lanthorn
