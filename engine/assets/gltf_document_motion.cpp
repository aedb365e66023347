// Adding skins and animations to a document.
#include <fmt/format.h>

#include "lanthorn/assets/buffer_bytes.h"
#include "lanthorn/assets/gltf_document_state.h"
#include "lanthorn/assets/gltf_format.h"

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

}  // namespace

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
    if (clip.channels.empty()) {
        state_->refuse(place, "found none, expected at least one");
    }
    for (std::size_t i = 0; i < clip.channels.size(); ++i) {
        const AnimationChannel& channel = clip.channels[i];
        const std::size_t keys =
            channel.times.size() * (channel.interpolation == Interpolation::cubic_spline ? 3 : 1);
        if (channel.node >= node_count()) {
            state_->refuse(fmt::format("{}/{}/target/node", place, i),
                           fmt::format("found {}, expected an index below {} (the number of nodes)",
                                       channel.node, node_count()));
        }
        if (keys == 0 || channel.values.size() != keys * channel.width) {
            state_->refuse(fmt::format("{}/{}", place, i),
                           fmt::format("found {} times and {} numbers, expected {} numbers a time",
                                       channel.times.size(), channel.values.size(), channel.width));
        }
    }
    JsonText target("{\"name\":" + json_quoted(clip.name) + "}");
    Json channels;
    Json samplers;
    for (const AnimationChannel& channel : clip.channels) {
        const auto path = static_cast<std::size_t>(channel.path);
        const std::size_t input = state_->share_accessor(
            bytes_of(channel.times), 0, "SCALAR", kFloat, channel.times.size(),
            {{"min", {plain_number(channel.times.front())}}, {"max", {plain_number(channel.times.back())}}});
        const std::size_t components = channel.path == AnimationPath::weights ? 1 : channel.width;
        const std::size_t output = state_->share_accessor(bytes_of(channel.values), 0, kTypes[path], kFloat,
                                                          channel.values.size() / components);
        samplers.push_back({{"input", input},
                            {"output", output},
                            {"interpolation", kModes[static_cast<std::size_t>(channel.interpolation)]}});
        channels.push_back(
            {{"sampler", samplers.size() - 1}, {"target", {{"node", channel.node}, {"path", kPaths[path]}}}});
    }
    target.set("channels", JsonText(channels.dump()));
    target.set("samplers", JsonText(samplers.dump()));
    return state_->append("animations", std::move(target));
}

}  // namespace lanthorn
