#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_context.h"
#include "engine/assets/gltf_format.h"
#include "engine/assets/gltf_integers.h"
#include "engine/assets/gltf_keys.h"
#include "engine/assets/gltf_pointers.h"

namespace lanthorn {

using nlohmann::json;

namespace {

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
    // What KHR_animation_pointer moves besides nodes, if it is that.
    std::optional<PointedProperty> pointed() const {
        return pointed_property(channel_["target"]["path"].get_ref<const std::string&>());
    }
    bool run(const PointedProperty& target, PropertyChannel& result) const;

  private:
    bool left_out(const std::string& place, const std::string& problem) const {
        context_.warn(place, problem + "; the channel is left out");
        return false;
    }
    bool read_target(AnimationChannel& result) const;
    bool read_target(const PointedProperty& target, PropertyChannel& result) const;
    bool read_keys(AnimationChannel& result, int type) const;
    bool read_interpolation(AnimationChannel& result) const;
    bool read_times(AnimationChannel& result) const;
    bool read_values(AnimationChannel& result, int type) const;
    bool check_output(std::size_t index, int type) const;
    Integers output_integers(const AnimationChannel& result, std::size_t index, int type) const;
    bool fit(AnimationChannel& result, std::size_t elements, std::size_t each) const;
    void give_weights(AnimationChannel& result, std::size_t found) const;
    bool repair(AnimationChannel& result) const;

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

// Nodes of the scene whose `member` is `object`.
std::vector<std::uint32_t> nodes_with(const SceneData& scene, std::uint32_t NodeData::*member,
                                      std::uint32_t object) {
    std::vector<std::uint32_t> result;
    for (std::uint32_t i = 0; i < scene.nodes.size(); ++i) {
        if (scene.nodes[i].*member == object) {
            result.push_back(i);
        }
    }
    return result;
}

bool ChannelImport::read_target(const PointedProperty& target, PropertyChannel& result) const {
    const SceneData& scene = context_.scene;
    const PropertyOwner owner = owner_of(target.property);
    const std::string place = place_ + "/target/path";
    const auto missing = [&](const char* what) {
        return left_out(place, fmt::format("there is no {} {} in the scene", what, target.object));
    };
    result.property = target.property;
    result.object = target.object;
    result.keys.width = width_of(target.property);
    result.keys.path = AnimationPath::weights;  // plain numbers
    result.keys.node = kNone;
    if (owner == PropertyOwner::material) {
        if (target.object >= context_.model.materials.size()) {
            return missing("material");
        }
        result.rest = property_of(scene.materials[target.object], target.property);
        return true;
    }
    const bool light = owner == PropertyOwner::light;
    const auto member = light ? &NodeData::light : &NodeData::camera;
    if (target.object >= (light ? context_.model.lights.size() : context_.model.cameras.size())) {
        return missing(light ? "light" : "camera");
    }
    result.nodes = nodes_with(scene, member, target.object);
    if (result.nodes.empty()) {
        return missing(light ? "light" : "camera");
    }
    result.rest = light ? property_of(scene.lights[target.object], target.property)
                        : property_of(scene.cameras[target.object], target.property);
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
    return true;
}

bool ChannelImport::check_output(std::size_t index, int type) const {
    const std::string place = sampler_place_ + "/output";
    if (context_.model.accessors[index].type != type) {
        return left_out(place, fmt::format("accessor {} is no {}", index,
                                           type == TINYGLTF_TYPE_SCALAR ? "SCALAR"
                                           : type == TINYGLTF_TYPE_VEC4 ? "VEC4"
                                                                        : "VEC3"));
    }
    if (!has_data(context_, index)) {
        return left_out(place, "its accessor has no data");
    }
    return true;
}

// Rotations and weights may be normalised integers (glTF 2.0, 3.11); integers elsewhere are numbers.
Integers ChannelImport::output_integers(const AnimationChannel& result, std::size_t index, int type) const {
    if (result.path == AnimationPath::rotation) {
        return integers_of(context_, index, NumbersUpTo::one, sampler_place_ + "/output");
    }
    return type == TINYGLTF_TYPE_SCALAR && result.node != kNone
               ? integers_of(context_, index, NumbersUpTo::a_sixteenth, sampler_place_ + "/output")
               : Integers::as_stated;
}

// Of keys with `found` weights each, those of the mesh's morph targets, 0 for those that are missing.
void ChannelImport::give_weights(AnimationChannel& result, std::size_t found) const {
    context_.warn(sampler_place_ + "/output",
                  fmt::format("{} weights a key, expected {}, one a morph target; 0 for those missing", found,
                              result.width));
    std::vector<float> values(result.values.size() / found * result.width, 0.0f);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        if (i % found < result.width) {
            values[i / found * result.width + i % found] = result.values[i];
        }
    }
    result.values = std::move(values);
}

// Makes the values as many as the times ask for, where the numbers of both leave one reading.
bool ChannelImport::fit(AnimationChannel& result, std::size_t elements, std::size_t each) const {
    const std::string place = sampler_place_ + "/output";
    const std::size_t keys = result.times.size();
    const bool cubic = result.interpolation == Interpolation::cubic_spline;
    if (elements == keys * each * (cubic ? 3 : 1)) {
        return true;
    }
    const std::string found = fmt::format("{} elements for {} keys", elements, keys);
    if (cubic && elements == keys * each) {
        context_.warn(place, found + ": values without tangents; read as LINEAR");
        result.interpolation = Interpolation::linear;
        return true;
    }
    if (result.interpolation == Interpolation::linear && elements == 3 * keys * each) {
        context_.warn(place, found + ": values with tangents; read as CUBICSPLINE");
        result.interpolation = Interpolation::cubic_spline;
        return true;
    }
    if (result.path == AnimationPath::weights && result.node != kNone && elements % keys == 0 &&
        elements / keys % (cubic ? 3 : 1) == 0) {
        give_weights(result, elements / keys / (cubic ? 3 : 1));
        return true;
    }
    const std::size_t elements_a_key = each * (cubic ? 3 : 1);
    const std::size_t whole = std::min(keys, elements / elements_a_key);
    const bool aligned = result.node == kNone || result.path != AnimationPath::weights || each == 1;
    if (whole == 0 || !aligned) {
        return left_out(place, fmt::format("{}, expected {}", found, keys * elements_a_key));
    }
    context_.warn(place,
                  fmt::format("{}, expected {}; {} used", found, keys * elements_a_key,
                              whole == 1 ? "the first key is" : fmt::format("the first {} keys are", whole)));
    result.times.resize(whole);
    result.values.resize(whole * result.width * (cubic ? 3 : 1));
    return true;
}

bool ChannelImport::repair(AnimationChannel& result) const {
    const KeyFaults faults = repair_keys(result);
    const std::string times = accessor_place(sampler_["input"]), values = accessor_place(sampler_["output"]);
    for (const std::string& line : faults.about_times()) {
        context_.warn(times, line);
    }
    for (const std::string& line : faults.about_values()) {
        context_.warn(values, line);
    }
    return !result.times.empty() || left_out(sampler_place_, "no key can be used");
}

bool ChannelImport::read_values(AnimationChannel& result, int type) const {
    const std::size_t index = sampler_["output"];
    if (!check_output(index, type)) {
        return false;
    }
    const bool scalar = type == TINYGLTF_TYPE_SCALAR;
    result.values =
        read_floats(context_, index, scalar ? 1 : result.width, 0, output_integers(result, index, type));
    return fit(result, context_.model.accessors[index].count, scalar ? result.width : 1) && repair(result);
}

bool ChannelImport::read_keys(AnimationChannel& result, int type) const {
    return read_interpolation(result) && read_times(result) && read_values(result, type);
}

bool ChannelImport::run(AnimationChannel& result) const {
    if (!read_target(result)) {
        return false;
    }
    return read_keys(result, result.path == AnimationPath::weights    ? TINYGLTF_TYPE_SCALAR
                             : result.path == AnimationPath::rotation ? TINYGLTF_TYPE_VEC4
                                                                      : TINYGLTF_TYPE_VEC3);
}

bool ChannelImport::run(const PointedProperty& target, PropertyChannel& result) const {
    constexpr int kTypes[] = {TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3,
                              TINYGLTF_TYPE_VEC4};
    return read_target(target, result) && read_keys(result.keys, kTypes[result.keys.width - 1]);
}

// What emission is in the file: a factor, and a strength, in their ranges.
struct FileEmission {
    vec3 factor{0};
    float strength = 1;
};

FileEmission emission_of(const GltfContext& context, std::uint32_t material) {
    const json& source = context.file.json["materials"][material];
    const json::json_pointer strength("/extensions/KHR_materials_emissive_strength/emissiveStrength");
    FileEmission result;
    if (source.contains(strength)) {
        result.strength = std::clamp(source[strength].get<float>(), 0.0f, kLargestKeyValue);
    }
    if (source.contains("emissiveFactor")) {
        for (int i = 0; i < 3; ++i) {
            const float factor = source["emissiveFactor"][static_cast<std::size_t>(i)].get<float>();
            result.factor[i] = std::clamp(factor, 0.0f, 1.0f);
        }
    }
    return result;
}

bool is_constant(const AnimationChannel& keys) {
    return keys.interpolation != Interpolation::cubic_spline &&
           std::ranges::all_of(keys.values, [&](float v) { return v == keys.values.front(); });
}

// A material shines with the product of a factor and a strength; a channel of either alone is made one of
// nits with the other as the file has it. Where a clip has both and the strength stays the same, so too; else
// they are both kept, and multiplied when they are played.
void join_emissions(const GltfContext& context, std::vector<PropertyChannel>& channels) {
    using enum AnimatedProperty;
    const auto find = [&](AnimatedProperty property, std::uint32_t material) {
        return std::ranges::find_if(channels, [&](const PropertyChannel& c) {
            return c.property == property && c.object == material;
        });
    };
    const auto scaled = [](PropertyChannel& channel, double factor) {
        for (float& value : channel.keys.values) {
            value = static_cast<float>(value * factor);
        }
    };
    for (std::uint32_t m = 0; m < context.model.materials.size(); ++m) {
        const auto factor = find(emissive, m), strength = find(emissive_scale, m);
        const FileEmission source =
            factor != channels.end() || strength != channels.end() ? emission_of(context, m) : FileEmission();
        if (factor != channels.end() && strength == channels.end()) {
            scaled(*factor, source.strength);
        } else if (factor != channels.end() && is_constant(strength->keys)) {
            scaled(*factor, strength->keys.values.front());
            channels.erase(strength);
        } else if (factor == channels.end() && strength != channels.end()) {
            std::vector<float> values;
            for (const float value : strength->keys.values) {
                for (int i = 0; i < 3; ++i) {
                    values.push_back(value * source.factor[i]);
                }
            }
            strength->keys.values = std::move(values);
            strength->keys.width = 3;
            strength->property = emissive;
            strength->rest = property_of(context.scene.materials[m], emissive);
        }
    }
}

AnimationClip import_clip(const GltfContext& context, const NodeMap& nodes, std::size_t index) {
    const json& source = context.file.json["animations"][index];
    const std::string place = fmt::format("/animations/{}", index);
    AnimationClip clip;
    clip.name = source.value("name", std::string());
    std::set<std::pair<std::uint32_t, AnimationPath>> targets;
    std::set<std::pair<std::uint32_t, AnimatedProperty>> properties;
    const auto is_first = [&](bool inserted, std::size_t c) {
        if (!inserted) {
            context.warn(fmt::format("{}/channels/{}/target", place, c),
                         "an earlier channel moves the same; the channel is left out");
        }
        return inserted;
    };
    for (std::size_t c = 0; c < source["channels"].size(); ++c) {
        const ChannelImport import(context, nodes, source, c, place);
        if (const std::optional<PointedProperty> target = import.pointed()) {
            PropertyChannel channel;
            if (import.run(*target, channel) &&
                is_first(properties.insert({target->object, target->property}).second, c)) {
                clip.duration = std::max(clip.duration, channel.keys.times.back());
                clip.properties.push_back(std::move(channel));
            }
            continue;
        }
        AnimationChannel channel;
        if (import.run(channel) && is_first(targets.insert({channel.node, channel.path}).second, c)) {
            clip.duration = std::max(clip.duration, channel.times.back());
            clip.channels.push_back(std::move(channel));
        }
    }
    join_emissions(context, clip.properties);
    std::ranges::sort(clip.properties, {}, [](const PropertyChannel& channel) {
        return std::tuple(owner_of(channel.property), channel.object, channel.property);
    });
    return clip;
}

}  // namespace

void import_animations(const GltfContext& context, const NodeMap& nodes) {
    const std::size_t count = context.file.json.value("animations", json::array()).size();
    for (std::size_t i = 0; i < count; ++i) {
        AnimationClip clip = import_clip(context, nodes, i);
        if (clip.channels.empty() && clip.properties.empty()) {
            context.warn(fmt::format("/animations/{}", i), "no channel can be played; left out");
        } else {
            context.scene.animations.push_back(std::move(clip));
        }
    }
}

}  // namespace lanthorn
