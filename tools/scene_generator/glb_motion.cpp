#include "tools/scene_generator/glb_motion.h"

#include <algorithm>
#include <limits>

namespace lanthorn::scene_generator {

using nlohmann::json;

namespace {

std::string bytes_of(const std::vector<float>& values) {
    std::string bytes;
    for (const float value : values) {
        append_f32(bytes, value);
    }
    return bytes;
}

void add_influences(GlbBuffer& buffer, const std::vector<SkinInfluences>& skin, json& attributes) {
    const bool eight =
        std::any_of(skin.begin(), skin.end(), [](const SkinInfluences& v) { return v.weights[4] > 0; });
    for (std::size_t set = 0; set < (eight ? 2u : 1u); ++set) {
        std::string joints;
        std::string weights;
        for (const SkinInfluences& vertex : skin) {
            for (std::size_t k = set * 4; k < set * 4 + 4; ++k) {
                append_u16(joints, vertex.joints[k]);
                append_f32(weights, vertex.weights[k]);
            }
        }
        const std::string number = std::to_string(set);
        attributes["JOINTS_" + number] =
            buffer.add_accessor(joints, GlbBuffer::kArrayBuffer, "VEC4", GlbBuffer::kShort, skin.size());
        attributes["WEIGHTS_" + number] =
            buffer.add_accessor(weights, GlbBuffer::kArrayBuffer, "VEC4", GlbBuffer::kFloat, skin.size());
    }
}

// Zero but for the vertices that are listed; sparse unless these are all.
std::size_t add_differences(GlbBuffer& buffer, const std::vector<std::uint32_t>& vertices,
                            const std::vector<vec3>& values, std::size_t count) {
    constexpr float kMost = std::numeric_limits<float>::max();
    const bool all = vertices.size() == count;
    std::string indices;
    std::string bytes;
    vec3 lower(all ? kMost : 0);
    vec3 upper(all ? -kMost : 0);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        append_u32(indices, vertices[i]);
        for (int c = 0; c < 3; ++c) {
            append_f32(bytes, values[i][c]);
        }
        lower = glm::min(lower, values[i]);
        upper = glm::max(upper, values[i]);
    }
    json accessor = {{"componentType", GlbBuffer::kFloat}, {"count", count}, {"type", "VEC3"}};
    for (int c = 0; c < 3; ++c) {
        accessor["min"].push_back(number(lower[c]));
        accessor["max"].push_back(number(upper[c]));
    }
    if (all) {
        accessor["bufferView"] = buffer.add_view(bytes, 0);
    } else if (!vertices.empty()) {
        accessor["sparse"] = {
            {"count", vertices.size()},
            {"indices", {{"bufferView", buffer.add_view(indices, 0)}, {"componentType", GlbBuffer::kInt}}},
            {"values", {{"bufferView", buffer.add_view(bytes, 0)}}}};
    }
    buffer.root["accessors"].push_back(accessor);
    return buffer.root["accessors"].size() - 1;
}

json cage_extras(const SubdivisionCage& cage) {
    json subdivision = {{"scheme", cage.scheme == SubdivisionScheme::loop ? "loop" : "catmull-clark"},
                        {"level", cage.level}};
    if (!cage.face_sizes.empty()) {
        subdivision["faces"] = cage.face_sizes;
    }
    for (const SubdivisionCrease& crease : cage.creases) {
        subdivision["creases"].push_back({crease.from, crease.to, number(crease.sharpness)});
    }
    return {{"subdivision", subdivision}};
}

}  // namespace

void add_deformation(GlbBuffer& buffer, const Mesh& mesh, json& primitive) {
    if (!mesh.skin.empty()) {
        add_influences(buffer, mesh.skin, primitive["attributes"]);
    }
    for (const MorphTarget& target : mesh.morphs) {
        json out = {
            {"POSITION", add_differences(buffer, target.vertices, target.positions, mesh.vertices.size())}};
        if (!target.normals.empty()) {
            out["NORMAL"] = add_differences(buffer, target.vertices, target.normals, mesh.vertices.size());
        }
        primitive["targets"].push_back(out);
    }
    if (mesh.cage) {
        primitive["extras"] = cage_extras(*mesh.cage);
    }
}

void write_skins(GlbBuffer& buffer, const SceneData& scene) {
    for (const Skin& skin : scene.skins) {
        std::string matrices;
        for (const mat4& matrix : skin.inverse_binds) {
            for (int i = 0; i < 16; ++i) {
                append_f32(matrices, matrix[i / 4][i % 4]);
            }
        }
        buffer.root["skins"].push_back(
            {{"name", skin.name},
             {"joints", skin.joints},
             {"inverseBindMatrices",
              buffer.share_accessor(matrices, 0, "MAT4", GlbBuffer::kFloat, skin.inverse_binds.size())}});
    }
}

void write_animations(GlbBuffer& buffer, const SceneData& scene) {
    constexpr const char* kPaths[] = {"translation", "rotation", "scale", "weights"};
    constexpr const char* kModes[] = {"STEP", "LINEAR", "CUBICSPLINE"};
    constexpr const char* kTypes[] = {"VEC3", "VEC4", "VEC3", "SCALAR"};
    for (const AnimationClip& clip : scene.animations) {
        json channels;
        json samplers;
        for (const AnimationChannel& channel : clip.channels) {
            const auto path = static_cast<std::size_t>(channel.path);
            const std::size_t input = buffer.share_accessor(bytes_of(channel.times), 0, "SCALAR",
                                                            GlbBuffer::kFloat, channel.times.size());
            buffer.root["accessors"][input]["min"] = {number(channel.times.front())};
            buffer.root["accessors"][input]["max"] = {number(channel.times.back())};
            const std::size_t components = channel.path == AnimationPath::weights ? 1 : channel.width;
            const std::size_t output =
                buffer.share_accessor(bytes_of(channel.values), 0, kTypes[path], GlbBuffer::kFloat,
                                      channel.values.size() / components);
            samplers.push_back({{"input", input},
                                {"output", output},
                                {"interpolation", kModes[static_cast<std::size_t>(channel.interpolation)]}});
            channels.push_back({{"sampler", samplers.size() - 1},
                                {"target", {{"node", channel.node}, {"path", kPaths[path]}}}});
        }
        buffer.root["animations"].push_back(
            {{"name", clip.name}, {"channels", channels}, {"samplers", samplers}});
    }
}

}  // namespace lanthorn::scene_generator
