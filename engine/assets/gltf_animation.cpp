#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "lanthorn/assets/gltf_accessor.h"
#include "lanthorn/assets/gltf_context.h"
#include "lanthorn/assets/gltf_format.h"

namespace lanthorn {

using nlohmann::json;

namespace {

constexpr float kLargestValue = 1e18f;  // so that no interpolation leaves the range of floats
constexpr float kLargestTime = 1e9f;    // seconds

// One channel of an animation (glTF 2.0, 3.11).
class ChannelImport {
  public:
    ChannelImport(const GltfContext& context, const NodeMap& nodes, const json& animation, std::size_t index,
                  const std::string& animation_place)
        : context_(context),
          nodes_(nodes),
          channel_(animation["channels"][index]),
          sampler_index_(channel_["sampler"]),
          sampler_(animation["samplers"][sampler_index_]),
          place_(fmt::format("{}/channels/{}", animation_place, index)),
          sampler_place_(fmt::format("{}/samplers/{}", animation_place, sampler_index_)) {}

    // False if the channel cannot be played; a warning says why.
    bool run(AnimationChannel& result) const;

  private:
    bool left_out(const std::string& place, const std::string& problem) const {
        context_.warn(place, problem + "; the channel is left out");
        return false;
    }
    bool read_target(AnimationChannel& result) const;
    bool read_interpolation(AnimationChannel& result) const;
    bool read_times(AnimationChannel& result) const;
    bool read_values(AnimationChannel& result) const;
    bool check_output(const AnimationChannel& result, std::size_t index) const;
    bool mend_rotations(AnimationChannel& result, std::size_t index) const;

    const GltfContext& context_;
    const NodeMap& nodes_;
    const json& channel_;
    std::size_t sampler_index_;
    const json& sampler_;
    std::string place_;
    std::string sampler_place_;
};

bool ChannelImport::read_target(AnimationChannel& result) const {
    const json& target = channel_["target"];
    const std::string& path = target["path"].get_ref<const std::string&>();
    if (path == "translation" || path == "scale") {
        result.path = path == "scale" ? AnimationPath::scale : AnimationPath::translation;
        result.width = 3;
    } else if (path == "rotation") {
        result.path = AnimationPath::rotation;
        result.width = 4;
    } else if (path == "weights") {
        result.path = AnimationPath::weights;
    } else {
        return left_out(place_ + "/target/path", fmt::format("'{}' is not animated here", path));
    }
    if (!target.contains("node")) {
        return left_out(place_ + "/target", "found no node");
    }
    const std::size_t node = target["node"];
    result.node = nodes_[node];
    if (result.node == kNone) {
        return left_out(place_ + "/target/node", fmt::format("node {} is not in the scene", node));
    }
    if (result.path == AnimationPath::weights) {
        std::size_t targets = 0;
        for (const std::uint32_t mesh : context_.scene.nodes[result.node].meshes) {
            targets = std::max(targets, context_.scene.meshes[mesh].morphs.size());
        }
        if (targets == 0) {
            return left_out(place_ + "/target/node", fmt::format("node {} has no morph targets", node));
        }
        result.width = static_cast<std::uint32_t>(targets);
    }
    return true;
}

bool ChannelImport::read_interpolation(AnimationChannel& result) const {
    const std::string name = sampler_.value("interpolation", std::string("LINEAR"));
    if (name == "LINEAR") {
        result.interpolation = Interpolation::linear;
    } else if (name == "STEP") {
        result.interpolation = Interpolation::step;
    } else if (name == "CUBICSPLINE") {
        result.interpolation = Interpolation::cubic_spline;
    } else {
        return left_out(sampler_place_ + "/interpolation",
                        fmt::format("found '{}', expected LINEAR, STEP or CUBICSPLINE", name));
    }
    return true;
}

bool ChannelImport::read_times(AnimationChannel& result) const {
    const std::size_t index = sampler_["input"];
    const tinygltf::Accessor& accessor = context_.model.accessors[index];
    if (accessor.type != TINYGLTF_TYPE_SCALAR ||
        static_cast<std::uint64_t>(accessor.componentType) != kFloat) {
        return left_out(sampler_place_ + "/input", fmt::format("accessor {} is no SCALAR of floats", index));
    }
    if (!has_data(context_, index)) {
        return left_out(sampler_place_ + "/input", "its accessor has no data");
    }
    result.times = read_floats(context_, index, 1);
    for (std::size_t k = 0; k < result.times.size(); ++k) {
        const float time = result.times[k];
        if (!(time >= 0 && time <= kLargestTime)) {
            return left_out(
                accessor_place(index),
                fmt::format("element {} is {}, expected seconds from 0 to {:g}", k, time, kLargestTime));
        }
        if (k > 0 && !(time > result.times[k - 1])) {
            return left_out(accessor_place(index),
                            fmt::format("element {} is {} after {}, expected key times that increase", k,
                                        time, result.times[k - 1]));
        }
    }
    return true;
}

bool ChannelImport::check_output(const AnimationChannel& result, std::size_t index) const {
    const tinygltf::Accessor& accessor = context_.model.accessors[index];
    const std::string place = sampler_place_ + "/output";
    const bool scalar = result.path == AnimationPath::weights;
    const int type = scalar                                   ? TINYGLTF_TYPE_SCALAR
                     : result.path == AnimationPath::rotation ? TINYGLTF_TYPE_VEC4
                                                              : TINYGLTF_TYPE_VEC3;
    if (accessor.type != type) {
        return left_out(place, fmt::format("accessor {} is no {}", index,
                                           scalar                       ? "SCALAR"
                                           : type == TINYGLTF_TYPE_VEC4 ? "VEC4"
                                                                        : "VEC3"));
    }
    if (static_cast<std::uint64_t>(accessor.componentType) != kFloat && !accessor.normalized) {
        return left_out(place, fmt::format("accessor {} has no floats or normalised integers", index));
    }
    const std::size_t parts = result.interpolation == Interpolation::cubic_spline ? 3 : 1;
    const std::size_t expected = result.times.size() * parts * (scalar ? result.width : 1);
    if (accessor.count != expected) {
        return left_out(place, fmt::format("accessor {} has {} elements, expected {} for {} keys", index,
                                           accessor.count, expected, result.times.size()));
    }
    if (!has_data(context_, index)) {
        return left_out(place, "its accessor has no data");
    }
    return true;
}

// Rotations that are no unit quaternions by more than the rounding of quantised ones are normalised.
bool ChannelImport::mend_rotations(AnimationChannel& result, std::size_t index) const {
    const bool cubic = result.interpolation == Interpolation::cubic_spline;
    std::size_t mended = 0;
    for (std::size_t k = 0; k < result.times.size(); ++k) {
        float* q = result.values.data() + (cubic ? k * 12 + 4 : k * 4);
        const double length =
            std::sqrt(double{q[0]} * q[0] + double{q[1]} * q[1] + double{q[2]} * q[2] + double{q[3]} * q[3]);
        if (!(length > 1e-12)) {
            return left_out(accessor_place(index), fmt::format("the rotation of key {} is zero", k));
        }
        if (std::abs(length - 1) > 1e-2) {
            ++mended;
            for (std::size_t c = 0; c < 4; ++c) {
                q[c] = static_cast<float>(q[c] / length);
            }
        }
    }
    if (mended > 0) {
        context_.warn(accessor_place(index),
                      fmt::format("{} rotations are not of length 1; normalised", mended));
    }
    return true;
}

bool ChannelImport::read_values(AnimationChannel& result) const {
    const std::size_t index = sampler_["output"];
    if (!check_output(result, index)) {
        return false;
    }
    const std::size_t components = result.path == AnimationPath::weights ? 1 : result.width;
    result.values = read_floats(context_, index, components);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        if (!(std::abs(result.values[i]) <= kLargestValue)) {
            return left_out(accessor_place(index),
                            fmt::format("element {} is {} (component {}), expected numbers up to {:g}",
                                        i / components, result.values[i], i % components, kLargestValue));
        }
    }
    return result.path != AnimationPath::rotation || mend_rotations(result, index);
}

bool ChannelImport::run(AnimationChannel& result) const {
    return read_target(result) && read_interpolation(result) && read_times(result) && read_values(result);
}

AnimationClip import_clip(const GltfContext& context, const NodeMap& nodes, std::size_t index) {
    const json& source = context.file.json["animations"][index];
    const std::string place = fmt::format("/animations/{}", index);
    AnimationClip clip;
    clip.name = source.value("name", std::string());
    std::set<std::pair<std::uint32_t, AnimationPath>> targets;
    for (std::size_t c = 0; c < source["channels"].size(); ++c) {
        AnimationChannel channel;
        if (!ChannelImport(context, nodes, source, c, place).run(channel)) {
            continue;
        }
        if (!targets.insert({channel.node, channel.path}).second) {
            context.warn(fmt::format("{}/channels/{}/target", place, c),
                         "an earlier channel moves the same; the channel is left out");
            continue;
        }
        clip.duration = std::max(clip.duration, channel.times.back());
        clip.channels.push_back(std::move(channel));
    }
    return clip;
}

}  // namespace

void import_animations(const GltfContext& context, const NodeMap& nodes) {
    const std::size_t count = context.file.json.value("animations", json::array()).size();
    for (std::size_t i = 0; i < count; ++i) {
        AnimationClip clip = import_clip(context, nodes, i);
        if (clip.channels.empty()) {
            context.warn(fmt::format("/animations/{}", i), "no channel can be played; left out");
        } else {
            context.scene.animations.push_back(std::move(clip));
        }
    }
}

}  // namespace lanthorn
