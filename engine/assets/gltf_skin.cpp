#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_context.h"
#include "engine/assets/gltf_format.h"

namespace lanthorn {

using nlohmann::json;

namespace {

// glTF 2.0, 3.7.3.1.
class SkinImport {
  public:
    SkinImport(const GltfContext& context, const NodeMap& nodes, std::size_t index)
        : context_(context),
          nodes_(nodes),
          source_(context.file.json["skins"][index]),
          place_(fmt::format("/skins/{}", index)) {}

    // Nothing, with a warning, if not all joints are in the scene.
    std::optional<Skin> run() const;

  private:
    std::vector<mat4> inverse_binds(std::size_t joints) const;

    const GltfContext& context_;
    const NodeMap& nodes_;
    const json& source_;
    std::string place_;
};

std::vector<mat4> SkinImport::inverse_binds(std::size_t joints) const {
    std::vector<mat4> result(joints, mat4(1));
    if (!source_.contains("inverseBindMatrices")) {
        return result;
    }
    const std::string place = place_ + "/inverseBindMatrices";
    const std::size_t index = source_["inverseBindMatrices"];
    const tinygltf::Accessor& accessor = context_.model.accessors[index];
    if (accessor.type != TINYGLTF_TYPE_MAT4 || static_cast<std::uint64_t>(accessor.componentType) != kFloat) {
        context_.refuse(place, fmt::format("accessor {} is no MAT4 of floats", index));
    }
    if (!has_data(context_, index)) {
        context_.warn(place, "its accessor has no data; identity matrices are used");
        return result;
    }
    if (accessor.count < joints) {
        context_.refuse(place, fmt::format("accessor {} has {} elements, expected at least {}, one a joint",
                                           index, accessor.count, joints));
    }
    const std::vector<float> values = read_floats(context_, index, 16);
    std::size_t projective = 0;
    for (std::size_t j = 0; j < joints; ++j) {
        for (std::size_t k = 0; k < 16; ++k) {
            const float value = values[j * 16 + k];
            if (!std::isfinite(value)) {
                context_.refuse(
                    accessor_place(index),
                    fmt::format("element {} is {} (component {}), expected finite matrices", j, value, k));
            }
            result[j][static_cast<int>(k / 4)][static_cast<int>(k % 4)] = value;
        }
        mat4& matrix = result[j];
        projective += matrix[0][3] != 0 || matrix[1][3] != 0 || matrix[2][3] != 0 || matrix[3][3] != 1;
        for (int column = 0; column < 4; ++column) {
            matrix[column][3] = column == 3 ? 1.0f : 0.0f;
        }
    }
    if (projective > 0) {
        context_.warn(
            place, fmt::format("the fourth rows of {} matrices are not 0 0 0 1; that is used", projective));
    }
    return result;
}

std::optional<Skin> SkinImport::run() const {
    Skin skin;
    skin.name = source_.value("name", std::string());
    const json& joints = source_["joints"];
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const std::uint32_t node = nodes_[joints[j].get<std::size_t>()];
        if (node == kNone) {
            context_.warn(fmt::format("{}/joints/{}", place_, j),
                          fmt::format("node {} is not in the scene; the skin is left out",
                                      joints[j].get<std::size_t>()));
            return std::nullopt;
        }
        skin.joints.push_back(node);
    }
    skin.inverse_binds = inverse_binds(skin.joints.size());
    return skin;
}

}  // namespace

void import_skins(const GltfContext& context, const NodeMap& nodes) {
    constexpr std::uint32_t kNotYet = kNone - 1;
    const std::size_t count = context.file.json.value("skins", json::array()).size();
    std::vector<std::uint32_t> skins(count, kNotYet);  // by glTF skin: index in scene.skins, kNone: left out
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const json& source = context.file.json["nodes"][i];
        if (nodes[i] == kNone || !source.contains("skin")) {
            continue;
        }
        NodeData& node = context.scene.nodes[nodes[i]];
        const bool skinned =
            !node.meshes.empty() && std::ranges::all_of(node.meshes, [&](std::uint32_t mesh) {
                return !context.scene.meshes[mesh].skin.empty();
            });
        if (!skinned) {
            context.warn(fmt::format("/nodes/{}/skin", i),
                         "expected a mesh whose primitives all have JOINTS_0 and WEIGHTS_0; not skinned");
            continue;
        }
        const std::size_t index = source["skin"];
        if (skins[index] == kNotYet) {
            auto skin = SkinImport(context, nodes, index).run();
            skins[index] = skin ? static_cast<std::uint32_t>(context.scene.skins.size()) : kNone;
            if (skin) {
                context.scene.skins.push_back(std::move(*skin));
            }
        }
        node.skin = skins[index];
    }
}

}  // namespace lanthorn
