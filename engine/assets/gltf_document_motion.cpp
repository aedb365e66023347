// Adding skins and animations to a document.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/assets/buffer_bytes.h"
#include "engine/assets/gltf_document_state.h"
#include "engine/assets/gltf_format.h"
#include "engine/assets/gltf_pointers.h"

namespace lanthorn {

namespace {

using Json = nlohmann::json;

std::string bytes_of(const std::vector<float>& values) {
    std::string bytes;
    for (const float value : values) {
        append_f32(bytes, value);
    }
    return bytes;
}

constexpr const char* kPointer = "KHR_animation_pointer";

// Emission is written as a factor of 0..1 and a strength that stays the same, a power of two, so that their
// product is what it was.
std::vector<PropertyChannel> written_properties(const AnimationClip& clip) {
    using enum AnimatedProperty;
    std::vector<PropertyChannel> result;
    for (const PropertyChannel& channel : clip.properties) {
        result.push_back(channel);
        const bool has_strength = std::ranges::any_of(clip.properties, [&](const PropertyChannel& c) {
            return c.property == emissive_scale && c.object == channel.object;
        });
        if (channel.property != emissive || has_strength || channel.keys.times.empty()) {
            continue;
        }
        float brightest = 1;
        for (const float value : channel.keys.values) {
            brightest = std::max(brightest, value);
        }
        const float strength = std::exp2(std::ceil(std::log2(brightest)));
        for (float& value : result.back().keys.values) {
            value /= strength;
        }
        PropertyChannel constant = channel;
        constant.property = emissive_scale;
        constant.keys.width = 1;
        constant.keys.interpolation = Interpolation::step;
        constant.keys.times = {channel.keys.times.front()};
        constant.keys.values = {strength};
        result.push_back(std::move(constant));
    }
    return result;
}

}  // namespace

void GltfDocument::State::expect_keys(const AnimationChannel& channel, const std::string& place) const {
    const std::size_t keys =
        channel.times.size() * (channel.interpolation == Interpolation::cubic_spline ? 3 : 1);
    if (keys == 0 || channel.values.size() != keys * channel.width) {
        refuse(place, fmt::format("found {} times and {} numbers, expected {} numbers a time",
                                  channel.times.size(), channel.values.size(), channel.width));
    }
}

void GltfDocument::State::make_owners(std::size_t material, std::string_view path) {
    JsonText* owner = &element("materials", material);
    for (std::size_t end = path.find('/'); end != path.npos; end = path.find('/')) {
        const std::string_view key = path.substr(0, end);
        if (key.ends_with("Texture")) {
            return;
        }
        owner = &object_at(*owner, key);
        if (key.starts_with("KHR_")) {
            use_extension(key);
        }
        path.remove_prefix(end + 1);
    }
}

std::size_t GltfDocument::add_skin(const Skin& skin) {
    const std::string place = fmt::format("/skins/{}", state_->count("skins"));
    if (skin.joints.empty() || skin.joints.size() != skin.inverse_binds.size()) {
        state_->refuse(place + "/inverseBindMatrices",
                       fmt::format("found {} joints and {} matrices, expected one for each joint",
                                   skin.joints.size(), skin.inverse_binds.size()));
    }
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        if (skin.joints[i] >= node_count()) {
            state_->refuse(fmt::format("{}/joints/{}", place, i),
                           fmt::format("found {}, expected an index below {} (the number of nodes)",
                                       skin.joints[i], node_count()));
        }
    }
    JsonText target("{\"name\":" + json_quoted(skin.name) + "}");
    target.set("joints", JsonText(Json(skin.joints).dump()));
    std::string matrices;
    for (const mat4& matrix : skin.inverse_binds) {
        for (int column = 0; column < 4; ++column) {
            append_vector(matrices, matrix[column]);
        }
    }
    const std::size_t accessor =
        state_->share_accessor(matrices, 0, "MAT4", kFloat, skin.inverse_binds.size());
    target.set("inverseBindMatrices", JsonText(std::to_string(accessor)));
    return state_->append("skins", std::move(target));
}

std::size_t GltfDocument::add_animation(const AnimationClip& clip) {
    constexpr const char* kPaths[] = {"translation", "rotation", "scale", "weights"};
    constexpr const char* kModes[] = {"STEP", "LINEAR", "CUBICSPLINE"};
    constexpr const char* kTypes[] = {"VEC3", "VEC4", "VEC3", "SCALAR"};
    const std::string place = fmt::format("/animations/{}/channels", state_->count("animations"));
    if (clip.channels.empty() && clip.properties.empty()) {
        state_->refuse(place, "found none, expected at least one");
    }
    for (std::size_t i = 0; i < clip.channels.size(); ++i) {
        const AnimationChannel& channel = clip.channels[i];
        if (channel.node >= node_count()) {
            state_->refuse(fmt::format("{}/{}/target/node", place, i),
                           fmt::format("found {}, expected an index below {} (the number of nodes)",
                                       channel.node, node_count()));
        }
        state_->expect_keys(channel, fmt::format("{}/{}", place, i));
    }
    const std::vector<PropertyChannel> properties = written_properties(clip);
    for (std::size_t i = 0; i < properties.size(); ++i) {
        const PropertyChannel& channel = properties[i];
        const PropertyOwner owner = owner_of(channel.property);
        const std::size_t count = owner == PropertyOwner::light    ? light_count()
                                  : owner == PropertyOwner::camera ? camera_count()
                                                                   : material_count();
        const std::string at = fmt::format("{}/{}", place, clip.channels.size() + i);
        if (channel.object >= count || channel.keys.width != width_of(channel.property)) {
            state_->refuse(
                at, fmt::format("found {} numbers of object {}, expected {} of one below {}",
                                channel.keys.width, channel.object, width_of(channel.property), count));
        }
        state_->expect_keys(channel.keys, at);
    }
    JsonText target("{\"name\":" + json_quoted(clip.name) + "}");
    Json channels;
    Json samplers;
    const auto add_channel = [&](const AnimationChannel& channel, const char* type, std::size_t components,
                                 Json moved) {
        const std::size_t input = state_->share_accessor(
            bytes_of(channel.times), 0, "SCALAR", kFloat, channel.times.size(),
            {{"min", {plain_number(channel.times.front())}}, {"max", {plain_number(channel.times.back())}}});
        const std::size_t output = state_->share_accessor(bytes_of(channel.values), 0, type, kFloat,
                                                          channel.values.size() / components);
        samplers.push_back({{"input", input},
                            {"output", output},
                            {"interpolation", kModes[static_cast<std::size_t>(channel.interpolation)]}});
        channels.push_back({{"sampler", samplers.size() - 1}, {"target", std::move(moved)}});
    };
    for (const AnimationChannel& channel : clip.channels) {
        const auto path = static_cast<std::size_t>(channel.path);
        add_channel(channel, kTypes[path], channel.path == AnimationPath::weights ? 1 : channel.width,
                    {{"node", channel.node}, {"path", kPaths[path]}});
    }
    for (const PropertyChannel& channel : properties) {
        constexpr const char* kWidths[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
        const bool orthographic =
            owner_of(channel.property) == PropertyOwner::camera &&
            parsed(state_->element("cameras", channel.object), "type") == "orthographic";
        const std::string pointer = pointer_to({channel.property, channel.object}, orthographic);
        add_channel(channel.keys, kWidths[channel.keys.width - 1], channel.keys.width,
                    {{"path", "pointer"}, {"extensions", {{kPointer, {{"pointer", pointer}}}}}});
        state_->use_extension(kPointer);
        if (owner_of(channel.property) == PropertyOwner::material) {
            const std::string material = fmt::format("/materials/{}/", channel.object);
            state_->make_owners(channel.object, std::string_view(pointer).substr(material.size()));
        }
    }
    target.set("channels", JsonText(channels.dump()));
    target.set("samplers", JsonText(samplers.dump()));
    return state_->append("animations", std::move(target));
}

}  // namespace lanthorn
