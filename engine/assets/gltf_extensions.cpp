#include "engine/assets/gltf_extensions.h"
#include "lanthorn/core/printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace lanthorn {

using nlohmann::json;

namespace {

constexpr std::array<std::string_view, 21> kRead = {"EXT_lights_image_based",
                                                    "EXT_mesh_gpu_instancing",
                                                    "EXT_meshopt_compression",
                                                    "EXT_texture_webp",
                                                    "KHR_animation_pointer",
                                                    "KHR_draco_mesh_compression",
                                                    "KHR_lights_punctual",
                                                    "KHR_materials_clearcoat",
                                                    "KHR_materials_emissive_strength",
                                                    "KHR_materials_ior",
                                                    "KHR_materials_pbrSpecularGlossiness",
                                                    "KHR_materials_sheen",
                                                    "KHR_materials_specular",
                                                    "KHR_materials_transmission",
                                                    "KHR_materials_unlit",
                                                    "KHR_materials_variants",
                                                    "KHR_materials_volume",
                                                    "KHR_mesh_quantization",
                                                    "KHR_node_visibility",
                                                    "KHR_texture_transform",
                                                    "KHR_xmp_json_ld"};  // says nothing of what is seen

constexpr std::string_view kBasis = "KHR_texture_basisu";

bool is_read(std::string_view name) {
    return std::ranges::find(kRead, name) != kRead.end();
}

// Without these a file still shows its shapes, though not all of their looks, or what else it knows of them:
// other loaders go on too.
constexpr std::array<std::string_view, 25> kLeftOut = {"EXT_feature_metadata",
                                                       "EXT_instance_features",
                                                       "EXT_mesh_features",
                                                       "EXT_structural_metadata",
                                                       "EXT_texture_avif",
                                                       "KHR_audio",
                                                       "KHR_audio_emitter",
                                                       "KHR_audio_graph",
                                                       "KHR_interactivity",
                                                       "KHR_materials_anisotropy",
                                                       "KHR_materials_diffuse_roughness",
                                                       "KHR_materials_diffuse_transmission",
                                                       "KHR_materials_dispersion",
                                                       "KHR_materials_iridescence",
                                                       "KHR_materials_subsurface",
                                                       "KHR_materials_volume_scatter",
                                                       "KHR_node_hoverability",
                                                       "KHR_node_selectability",
                                                       "KHR_physics_rigid_bodies",
                                                       "KHR_texture_basisu",
                                                       "KHR_texture_procedurals",
                                                       "KHR_xmp",
                                                       "MSFT_audio_emitter",
                                                       "MSFT_lod",
                                                       "MSFT_texture_dds"};
// Of all that a vendor's names begin with.
constexpr std::array<std::string_view, 8> kLeftOutOf = {
    "ADOBE_materials_", "AGI_stk_metadata", "GODOT_", "MPEG_audio_",
    "MPEG_texture_",    "NV_materials_",    "OMI_",   "VRM"};

bool shows_without(std::string_view name) {
    return std::ranges::find(kLeftOut, name) != kLeftOut.end() ||
           std::ranges::any_of(kLeftOutOf, [&](std::string_view start) { return name.starts_with(start); });
}

std::vector<std::string> names_in(const JsonPlace& root, const char* key) {
    const auto found = root.value().find(key);
    if (found == root.value().end()) {
        return {};
    }
    const auto is_name = [](const json& name) { return name.is_string(); };
    if (!found->is_array() || !std::ranges::all_of(*found, is_name)) {
        root.refuse(key, "expected an array of strings");
    }
    return found->get<std::vector<std::string>>();
}

// A top-level array, made if there is none.
json& elements(json& root, const char* key) {
    json& array = root[key];
    array = array.is_null() ? json::array() : std::move(array);
    return array;
}

json* extension(json& owner, const char* name) {
    const json::json_pointer place(std::string("/extensions/") + name);
    return owner.contains(place) ? &owner[place] : nullptr;
}

// --- KHR_node_visibility ---

void hide_nodes(json& root) {
    json& nodes = elements(root, "nodes");
    std::vector<std::size_t> pending;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const json* visibility = extension(nodes[i], "KHR_node_visibility");
        if (visibility != nullptr && !visibility->value("visible", true)) {
            pending.push_back(i);
        }
    }
    std::vector<bool> hidden(nodes.size(), false);
    while (!pending.empty()) {
        const std::size_t i = pending.back();
        pending.pop_back();
        if (hidden[i]) {
            continue;
        }
        hidden[i] = true;
        for (const char* key : {"mesh", "skin", "weights"}) {
            nodes[i].erase(key);
        }
        if (extension(nodes[i], "KHR_lights_punctual") != nullptr) {
            nodes[i]["extensions"].erase("KHR_lights_punctual");
        }
        for (const json& child : nodes[i].value("children", json::array())) {
            pending.push_back(child);
        }
    }
}

// --- KHR_materials_variants ---

void choose_variant(GltfFile& file, const std::string& wanted) {
    std::vector<std::string> names;
    if (json* variants = extension(file.json, "KHR_materials_variants")) {
        for (const json& variant : (*variants)["variants"]) {
            names.push_back(variant["name"]);
        }
    }
    if (wanted.empty()) {
        return;
    }
    const auto found = std::ranges::find(names, wanted);
    if (found == names.end()) {
        file.refuse("/extensions/KHR_materials_variants",
                    fmt::format("found no variant '{}', expected {}", wanted,
                                names.empty() ? "none" : fmt::format("one of: {}", fmt::join(names, ", "))));
    }
    const auto number = static_cast<std::uint64_t>(found - names.begin());
    for (json& mesh : elements(file.json, "meshes")) {
        for (json& primitive : mesh["primitives"]) {
            const json* own = extension(primitive, "KHR_materials_variants");
            const json mappings = own == nullptr ? json::array() : (*own)["mappings"];
            for (const json& mapping : mappings) {
                if (std::ranges::find(mapping["variants"], json(number)) != mapping["variants"].end()) {
                    primitive["material"] = mapping["material"];
                }
            }
        }
    }
}

// --- EXT_texture_webp ---

void use_webp(json& root) {
    for (json& texture : elements(root, "textures")) {
        if (const json* webp = extension(texture, "EXT_texture_webp"); webp && webp->contains("source")) {
            texture["source"] = (*webp)["source"];
        }
    }
}

// --- KHR_animation_pointer ---

// "/nodes/3/rotation" as a channel's target of the core format.
std::optional<json> node_target(const std::string& pointer, std::size_t nodes) {
    constexpr std::string_view start = "/nodes/";
    const std::size_t slash = pointer.find('/', start.size());
    if (!pointer.starts_with(start) || slash == std::string::npos) {
        return std::nullopt;
    }
    const char* end = pointer.data() + slash;
    std::size_t node = 0;
    const auto [rest, error] = std::from_chars(pointer.data() + start.size(), end, node);
    const std::string path = pointer.substr(slash + 1);
    const bool moves = path == "translation" || path == "rotation" || path == "scale" || path == "weights";
    if (error != std::errc() || rest != end || node >= nodes || !moves) {
        return std::nullopt;
    }
    return json{{"node", node}, {"path", path}};
}

void point_at_nodes(json& root) {
    const std::size_t nodes = elements(root, "nodes").size();
    for (json& animation : elements(root, "animations")) {
        for (json& channel : animation["channels"]) {
            json& target = channel["target"];
            const json* own = extension(target, "KHR_animation_pointer");
            if (target["path"] != "pointer" || own == nullptr) {
                continue;
            }
            const std::string pointer = own->value("pointer", std::string());
            if (const std::optional<json> plain = node_target(pointer, nodes)) {
                target = *plain;
            } else {
                target["path"] = pointer;  // for who reads the channel
            }
        }
    }
}

// --- KHR_materials_pbrSpecularGlossiness ---

// Textures whose alpha is read as glossiness: one for each texture and factor, and one image for each image
// and factor, however many materials use them.
class GlossinessTextures {
  public:
    explicit GlossinessTextures(GltfFile& file) : file_(file) {}

    // The texture that `info` refers to, referred to in the same way.
    json as_roughness(const json& info, double factor) {
        const std::size_t texture = info["index"];
        const auto [known, added] = textures_.try_emplace({texture, factor});
        if (added) {
            json copy = elements(file_.json, "textures")[texture];
            if (copy.contains("source")) {
                copy["source"] = image(copy["source"], factor);
            }
            known->second = appended("textures", std::move(copy));
        }
        json result = info;
        result["index"] = known->second;
        return result;
    }

  private:
    using Numbers = std::map<std::pair<std::size_t, double>, std::size_t>;

    std::size_t image(std::size_t source, double factor) {
        const auto [known, added] = images_.try_emplace({source, factor});
        if (added) {
            known->second = appended("images", json(file_.json["images"][source]));
            file_.glossiness[known->second] = factor;
        }
        return known->second;
    }
    std::size_t appended(const char* key, json value) {
        json& array = elements(file_.json, key);
        array.push_back(std::move(value));
        return array.size() - 1;
    }

    GltfFile& file_;
    Numbers textures_, images_;
};

// Diffuse and specular colour are what KHR_materials_specular says of a material that is no metal: it
// reflects F0 = min(0.04 * specular colour, 1) at normal incidence, all at grazing angles, and
// the diffuse part is what that leaves; so a specular colour of 1 / 0.04 times the file's is the same
// reflectance. (The conversion to a metal, of the extension's appendix, loses it where both parts are
// strong.)
void convert_glossiness(GltfFile& file) {
    constexpr double kDielectric = 0.04;  // of ior 1.5
    GlossinessTextures textures(file);
    for (json& material : elements(file.json, "materials")) {
        const json* found = extension(material, "KHR_materials_pbrSpecularGlossiness");
        if (found == nullptr) {
            continue;
        }
        const json source = *found;
        const double glossiness = std::clamp(source.value("glossinessFactor", 1.0), 0.0, 1.0);
        json pbr{{"metallicFactor", 0.0},
                 {"roughnessFactor", 1 - glossiness},
                 {"baseColorFactor", source.value("diffuseFactor", json{1.0, 1.0, 1.0, 1.0})}};
        json specular{{"specularColorFactor", json::array()}};
        for (const json& channel : source.value("specularFactor", json{1.0, 1.0, 1.0})) {
            specular["specularColorFactor"].push_back(channel.get<double>() / kDielectric);
        }
        if (source.contains("diffuseTexture")) {
            pbr["baseColorTexture"] = source["diffuseTexture"];
        }
        if (source.contains("specularGlossinessTexture")) {
            const json& info = source["specularGlossinessTexture"];
            specular["specularColorTexture"] = info;
            pbr["roughnessFactor"] = 1.0;
            pbr["metallicRoughnessTexture"] = textures.as_roughness(info, glossiness);
        }
        material["pbrMetallicRoughness"] = std::move(pbr);
        material["extensions"]["KHR_materials_specular"] = std::move(specular);
        material["extensions"].erase("KHR_materials_ior");
    }
}

}  // namespace

std::span<const std::string_view> read_extensions() {
    return kRead;
}

std::span<const std::string_view> extensions_left_out() {
    return kLeftOut;
}

std::span<const std::string_view> extension_starts_left_out() {
    return kLeftOutOf;
}

void check_extensions(const JsonPlace& root) {
    const std::vector<std::string> required = names_in(root, "extensionsRequired");
    for (std::size_t i = 0; i < required.size(); ++i) {
        if (!is_read(required[i]) && !shows_without(required[i])) {
            root.file().refuse(
                fmt::format("/extensionsRequired/{}", i),
                fmt::format("the file requires the extension '{}', which is not supported", required[i]));
        }
    }
    std::set<std::string> unread;
    bool basis = false;
    for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
        for (const std::string& name : names_in(root, key)) {
            basis = basis || name == kBasis;
            if (name != kBasis && !is_read(name)) {
                unread.insert(name);
            }
        }
    }
    if (!unread.empty()) {
        root.note("extensionsUsed", fmt::format("{} {} not read; what {} left out",
                                                shortened(fmt::format("{}", fmt::join(unread, ", ")), 300),
                                                unread.size() == 1 ? "is" : "are",
                                                unread.size() == 1 ? "it adds is" : "they add is"));
    }
    if (basis) {
        root.note(
            "extensionsUsed",
            "the KTX2 textures of KHR_texture_basisu are not read; 'gltf-transform ktxdecompress IN OUT' "
            "writes the file with PNG instead");
    }
}

void restate_extensions(GltfFile& file, const std::string& variant) {
    use_webp(file.json);
    choose_variant(file, variant);
    hide_nodes(file.json);
    point_at_nodes(file.json);
    convert_glossiness(file);
}

}  // namespace lanthorn
