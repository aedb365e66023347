// Adding meshes to a document: vertices, influences, morph targets and cages as accessors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/assets/buffer_bytes.h"
#include "engine/assets/gltf_document_state.h"
#include "engine/assets/gltf_format.h"
#include "engine/assets/gltf_uv_sets.h"
#include "engine/core/finite.h"

namespace lanthorn {

namespace {

using Json = nlohmann::json;

constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

// What a material reads from vertices.
struct Use {
    std::set<std::uint32_t> uv_sets;
    bool tangents = false;
};

// Of the textures that the importer reads, of a document that check_gltf() has passed.
Use use_of(const Json& material) {
    std::vector<std::string> textures = {"/normalTexture", "/occlusionTexture", "/emissiveTexture",
                                         "/extensions/KHR_materials_transmission/transmissionTexture"};
    const std::string glossiness = "/extensions/KHR_materials_pbrSpecularGlossiness";
    if (material.contains(Json::json_pointer(glossiness))) {  // takes the place of the other two
        textures.insert(textures.end(),
                        {glossiness + "/diffuseTexture", glossiness + "/specularGlossinessTexture"});
    } else {
        textures.insert(textures.end(), {"/pbrMetallicRoughness/baseColorTexture",
                                         "/pbrMetallicRoughness/metallicRoughnessTexture",
                                         "/extensions/KHR_materials_specular/specularTexture",
                                         "/extensions/KHR_materials_specular/specularColorTexture"});
    }
    Use use;
    for (const std::string& texture : textures) {
        const Json::json_pointer place(texture);
        if (material.contains(place)) {
            const Json& info = material[place];
            const Json transform =
                info.value("/extensions/KHR_texture_transform"_json_pointer, Json::object());
            use.uv_sets.insert(transform.value("texCoord", info.value("texCoord", 0u)));
            use.tangents = use.tangents || texture == "/normalTexture";
        }
    }
    return use;
}

bool is_sound(const Mesh& mesh) {
    for (const Vertex& v : mesh.vertices) {
        if (!is_finite(v.position) || !is_finite(v.normal) || !is_finite(v.tangent) || !is_finite(v.uv0) ||
            !is_finite(v.uv1) || !is_finite(v.colour)) {
            return false;
        }
    }
    return std::all_of(mesh.indices.begin(), mesh.indices.end(),
                       [&](std::uint32_t index) { return index < mesh.vertices.size(); });
}

Json cage_extras(const SubdivisionCage& cage) {
    Json subdivision = {{"scheme", cage.scheme == SubdivisionScheme::loop ? "loop" : "catmull-clark"},
                        {"level", cage.level}};
    if (!cage.face_sizes.empty()) {
        subdivision["faces"] = cage.face_sizes;
    }
    for (const SubdivisionCrease& crease : cage.creases) {
        subdivision["creases"].push_back({crease.from, crease.to, plain_number(crease.sharpness)});
    }
    return {{"subdivision", subdivision}};
}

}  // namespace

// Adds the accessors of one primitive.
class PrimitiveWriter {
  public:
    PrimitiveWriter(GltfDocument::State& state, const Mesh& mesh) : state_(state), mesh_(mesh) {}

    Json run();

  private:
    template <typename V>
    void add_attribute(const char* name, const char* type, V Vertex::*member, Json members = Json::object());
    void add_influences();
    void add_targets();
    std::size_t add_differences(const std::vector<std::uint32_t>& vertices, const std::vector<vec3>& values);
    std::size_t add_indices();

    GltfDocument::State& state_;
    const Mesh& mesh_;
    Json result_ = {{"attributes", Json::object()}};
};

template <typename V>
void PrimitiveWriter::add_attribute(const char* name, const char* type, V Vertex::*member, Json members) {
    std::string bytes;
    for (const Vertex& vertex : mesh_.vertices) {
        append_vector(bytes, vertex.*member);
    }
    result_["attributes"][name] =
        state_.add_accessor(bytes, kArrayBuffer, type, kFloat, mesh_.vertices.size(), std::move(members));
}

void PrimitiveWriter::add_influences() {
    const std::vector<SkinInfluences>& skin = mesh_.skin;
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
        result_["attributes"][fmt::format("JOINTS_{}", set)] =
            state_.add_accessor(joints, kArrayBuffer, "VEC4", kUnsignedShort, skin.size());
        result_["attributes"][fmt::format("WEIGHTS_{}", set)] =
            state_.add_accessor(weights, kArrayBuffer, "VEC4", kFloat, skin.size());
    }
}

// Zero but for the vertices that are listed; sparse unless these are all.
std::size_t PrimitiveWriter::add_differences(const std::vector<std::uint32_t>& vertices,
                                             const std::vector<vec3>& values) {
    const bool all = vertices.size() == mesh_.vertices.size();
    std::string indices;
    std::string bytes;
    vec3 lower = all ? values.front() : vec3(0);
    vec3 upper = lower;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        append_u32(indices, vertices[i]);
        append_vector(bytes, values[i]);
        lower = glm::min(lower, values[i]);
        upper = glm::max(upper, values[i]);
    }
    Json accessor = {{"componentType", kFloat},
                     {"count", mesh_.vertices.size()},
                     {"type", "VEC3"},
                     {"min", plain_numbers(lower)},
                     {"max", plain_numbers(upper)}};
    if (all) {
        accessor["bufferView"] = state_.add_view(bytes, 0);
    } else if (!vertices.empty()) {
        const std::size_t index_view = state_.add_view(indices, 0);
        accessor["sparse"] = {{"count", vertices.size()},
                              {"indices", {{"bufferView", index_view}, {"componentType", kUnsignedInt}}},
                              {"values", {{"bufferView", state_.add_view(bytes, 0)}}}};
    }
    return state_.append("accessors", JsonText(accessor.dump()));
}

void PrimitiveWriter::add_targets() {
    for (const MorphTarget& target : mesh_.morphs) {
        Json out = {{"POSITION", add_differences(target.vertices, target.positions)}};
        if (!target.normals.empty()) {
            out["NORMAL"] = add_differences(target.vertices, target.normals);
        }
        if (!target.tangents.empty()) {
            out["TANGENT"] = add_differences(target.vertices, target.tangents);
        }
        result_["targets"].push_back(out);
    }
}

std::size_t PrimitiveWriter::add_indices() {
    const bool wide = mesh_.vertices.size() > 0xffff;
    std::string bytes;
    for (const std::uint32_t index : mesh_.indices) {
        if (wide) {
            append_u32(bytes, index);
        } else {
            append_u16(bytes, static_cast<std::uint16_t>(index));
        }
    }
    return state_.add_accessor(bytes, kElementArrayBuffer, "SCALAR", wide ? kUnsignedInt : kUnsignedShort,
                               mesh_.indices.size());
}

Json PrimitiveWriter::run() {
    const Use use = use_of(parsed(state_.element("materials", mesh_.material)));
    Aabb bounds;
    bool coloured = false;
    for (const Vertex& vertex : mesh_.vertices) {
        bounds.add(vertex.position);
        coloured = coloured || vertex.colour != vec4(1);
    }
    add_attribute("POSITION", "VEC3", &Vertex::position,
                  {{"min", plain_numbers(bounds.lower)}, {"max", plain_numbers(bounds.upper)}});
    add_attribute("NORMAL", "VEC3", &Vertex::normal);
    if (use.tangents) {
        add_attribute("TANGENT", "VEC4", &Vertex::tangent);
    }
    const UvSets sets = choose_uv_sets(use.uv_sets);
    for (const auto& [set, member] : {std::pair(sets[0], &Vertex::uv0), {sets[1], &Vertex::uv1}}) {
        if (use.uv_sets.contains(set)) {
            add_attribute(fmt::format("TEXCOORD_{}", set).c_str(), "VEC2", member);
        }
    }
    if (coloured) {
        add_attribute("COLOR_0", "VEC4", &Vertex::colour);
    }
    result_["indices"] = add_indices();
    result_["material"] = mesh_.material;
    if (!mesh_.skin.empty()) {
        add_influences();
    }
    add_targets();
    if (mesh_.cage) {
        result_["extras"] = cage_extras(*mesh_.cage);
    }
    return std::move(result_);
}

std::size_t GltfDocument::add_mesh(const std::vector<const Mesh*>& primitives) {
    const std::string place = fmt::format("/meshes/{}", mesh_count());
    if (primitives.empty()) {
        state_->refuse(place + "/primitives", "found none, expected at least one");
    }
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        const Mesh& mesh = *primitives[i];
        const std::string primitive = fmt::format("{}/primitives/{}", place, i);
        if (mesh.vertices.empty() || mesh.indices.empty() || !is_sound(mesh)) {
            state_->refuse(primitive, "expected vertices of finite numbers, and indices of them");
        }
        if (mesh.material >= material_count()) {
            state_->refuse(primitive + "/material",
                           fmt::format("found {}, expected an index below {} (the number of materials)",
                                       mesh.material, material_count()));
        }
    }
    const Mesh& first = *primitives.front();
    JsonText target("{\"name\":" + json_quoted(first.name) + "}");
    Json list = Json::array();
    for (const Mesh* mesh : primitives) {
        list.push_back(PrimitiveWriter(*state_, *mesh).run());
    }
    target.set("primitives", JsonText(list.dump()));
    if (!first.morph_weights.empty()) {
        Json weights = Json::array();
        for (const float weight : first.morph_weights) {
            weights.push_back(plain_number(weight));
        }
        target.set("weights", JsonText(weights.dump()));
    }
    return state_->append("meshes", std::move(target));
}

}  // namespace lanthorn
