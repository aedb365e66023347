#include <array>
#include <cmath>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_deformation.h"
#include "engine/assets/gltf_integers.h"

namespace lanthorn {

namespace {

class TargetImport {
  public:
    TargetImport(const GltfContext& context, const nlohmann::json& target, std::string place,
                 std::size_t vertices)
        : context_(context), target_(target), place_(std::move(place)), vertices_(vertices) {}

    MorphTarget run() const;

  private:
    // One difference a vertex; none if the target has no such attribute.
    std::vector<float> differences(const char* name) const;

    const GltfContext& context_;
    const nlohmann::json& target_;
    std::string place_;
    std::size_t vertices_;
};

std::vector<float> TargetImport::differences(const char* name) const {
    const auto found = target_.find(name);
    if (found == target_.end()) {
        return {};
    }
    const std::string place = fmt::format("{}/{}", place_, name);
    const auto index = found->get<std::size_t>();
    if (!has_data(context_, index)) {
        context_.warn(place, "its accessor has no data; left out");
        return {};
    }
    // Differences of positions may be plain numbers (KHR_mesh_quantization).
    const Integers integers = std::string_view(name) == "POSITION"
                                  ? Integers::as_stated
                                  : integers_of(context_, index, NumbersUpTo::one, place);
    std::vector<float> values = read_attribute(context_, index, place, {3, 3, vertices_}, 0, integers);
    std::size_t bad = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(values[i])) {
            continue;
        }
        values[i] = 0;
        ++bad;
    }
    if (bad > 0) {
        context_.warn(place, fmt::format("{} values are not finite; 0 is used", bad));
    }
    return values;
}

vec3 at(const std::vector<float>& values, std::size_t vertex) {
    return values.empty() ? vec3(0)
                          : vec3(values[vertex * 3], values[vertex * 3 + 1], values[vertex * 3 + 2]);
}

MorphTarget TargetImport::run() const {
    const std::vector<float> positions = differences("POSITION");
    const std::vector<float> normals = differences("NORMAL");
    const std::vector<float> tangents = differences("TANGENT");
    for (const auto& [name, value] : target_.items()) {
        if (name != "POSITION" && name != "NORMAL" && name != "TANGENT") {
            context_.warn(fmt::format("{}/{}", place_, name),
                          "only positions, normals and tangents are morphed; left out");
        }
    }
    MorphTarget result;
    bool turns_normals = false;
    bool turns_tangents = false;
    for (std::size_t v = 0; v < vertices_; ++v) {
        const vec3 position = at(positions, v);
        const vec3 normal = at(normals, v);
        const vec3 tangent = at(tangents, v);
        if (position == vec3(0) && normal == vec3(0) && tangent == vec3(0)) {
            continue;
        }
        result.vertices.push_back(static_cast<std::uint32_t>(v));
        result.positions.push_back(position);
        result.normals.push_back(normal);
        result.tangents.push_back(tangent);
        turns_normals = turns_normals || normal != vec3(0);
        turns_tangents = turns_tangents || tangent != vec3(0);
    }
    if (!turns_normals) {
        result.normals = {};
    }
    if (!turns_tangents) {
        result.tangents = {};
    }
    return result;
}

}  // namespace

std::vector<MorphTarget> read_morphs(const GltfContext& context, const nlohmann::json& primitive,
                                     const std::string& place, std::size_t vertices) {
    std::vector<MorphTarget> morphs;
    const auto targets = primitive.find("targets");
    for (std::size_t t = 0; targets != primitive.end() && t < targets->size(); ++t) {
        morphs.push_back(
            TargetImport(context, (*targets)[t], fmt::format("{}/targets/{}", place, t), vertices).run());
    }
    return morphs;
}

void make_flat_morph_normals(const Mesh& mesh, std::vector<MorphTarget>& morphs) {
    for (MorphTarget& target : morphs) {
        std::vector<vec3> moved(mesh.vertices.size(), vec3(0));
        for (std::size_t i = 0; i < target.vertices.size(); ++i) {
            moved[target.vertices[i]] = target.positions[i];
        }
        MorphTarget flat;
        for (std::size_t c = 0; c < mesh.indices.size(); c += 3) {
            const std::array<std::uint32_t, 3> corners = {mesh.indices[c], mesh.indices[c + 1],
                                                          mesh.indices[c + 2]};
            std::array<vec3, 3> positions;
            bool moves = false;
            for (std::size_t k = 0; k < 3; ++k) {
                positions[k] = mesh.vertices[corners[k]].position + moved[corners[k]];
                moves = moves || moved[corners[k]] != vec3(0);
            }
            const vec3 normal = triangle_normal(positions);
            for (std::size_t k = 0; k < 3 && moves; ++k) {
                flat.vertices.push_back(corners[k]);
                flat.positions.push_back(moved[corners[k]]);
                flat.normals.push_back(normal == vec3(0) ? vec3(0)
                                                         : normal - mesh.vertices[corners[k]].normal);
            }
        }
        target = std::move(flat);
    }
}

MorphTarget remapped(const MorphTarget& target, const VertexSources& sources, std::size_t vertices_before) {
    std::vector<std::uint32_t> entry(vertices_before, kNone);
    for (std::size_t i = 0; i < target.vertices.size(); ++i) {
        entry[target.vertices[i]] = static_cast<std::uint32_t>(i);
    }
    MorphTarget result;
    for (std::size_t v = 0; v < sources.size(); ++v) {
        const std::uint32_t from = entry[sources[v]];
        if (from == kNone) {
            continue;
        }
        result.vertices.push_back(static_cast<std::uint32_t>(v));
        result.positions.push_back(target.positions[from]);
        if (!target.normals.empty()) {
            result.normals.push_back(target.normals[from]);
        }
        if (!target.tangents.empty()) {
            result.tangents.push_back(target.tangents[from]);
        }
    }
    return result;
}

}  // namespace lanthorn
