// A document's materials of KHR_materials_pbrSpecularGlossiness, said in the format's own words.
#include <fmt/format.h>

#include <algorithm>

#include "engine/assets/glossiness.h"
#include "engine/assets/gltf_document_state.h"
#include "engine/assets/image_decode.h"
#include "engine/assets/uri.h"
#include "engine/assets/uri_file.h"

namespace lanthorn {

using Json = nlohmann::json;

namespace {

constexpr const char* kExtension = "KHR_materials_pbrSpecularGlossiness";

std::vector<std::uint8_t> bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}

}  // namespace

std::vector<std::uint8_t> GltfDocument::State::image_bytes(const JsonText& image) const {
    if (const Json view_index = parsed(image, "bufferView"); view_index.is_number()) {
        const JsonText& view = element("bufferViews", view_index.get<std::size_t>());
        const std::string buffer = buffer_bytes(index_at(view, "buffer", 0));
        return bytes_of(buffer.substr(index_at(view, "byteOffset", 0), index_at(view, "byteLength", 0)));
    }
    const std::string uri = parsed(image, "uri").get<std::string>();
    if (is_data_uri(uri)) {
        return decode_data_uri(uri).value_or(std::vector<std::uint8_t>());
    }
    const UriFile found = find_uri_file(source.parent_path(), uri, allow_outside, *folders);
    return found.problem.empty() ? read_bytes(found.path, name, "/images") : std::vector<std::uint8_t>();
}

// Nothing where the importer goes without the image too.
std::optional<Json> GltfDocument::State::roughness_texture(const Json& info, double factor) {
    const std::size_t texture = info["index"];
    const auto [known, added] = roughness.try_emplace({texture, factor}, std::nullopt);
    if (added) {
        Json copy = parsed(element("textures", texture));
        const Json::json_pointer webp("/extensions/EXT_texture_webp/source");
        const Json from = copy.contains(webp) ? copy[webp] : copy.value("source", Json());
        DecodedImage decoded;
        if (from.is_number()) {
            const JsonText& image = element("images", from.get<std::size_t>());
            decoded = decode_image(image_bytes(image));
            decoded.image.name = parsed(image).value("name", std::string());
        }
        if (!decoded.image.rgba.empty()) {
            roughness_of_glossiness(decoded.image, factor);
            copy.erase("extensions");
            copy["source"] = add_image(decoded.image);
            known->second = append("textures", JsonText(copy.dump()));
        }
    }
    if (!known->second) {
        return std::nullopt;
    }
    Json result = info;
    result["index"] = *known->second;
    return result;
}

void GltfDocument::State::restate_glossiness(JsonText& material) {
    JsonText* extensions = material.find("extensions");
    const JsonText* found = extensions == nullptr ? nullptr : extensions->find(kExtension);
    if (found == nullptr) {
        return;
    }
    const Json own = parsed(*found);
    extensions->erase(kExtension);
    // What the material says beside it is for programs that do not read it.
    JsonText& pbr = object_at(material, "pbrMetallicRoughness");
    pbr.erase("baseColorTexture");
    pbr.erase("metallicRoughnessTexture");
    if (JsonText* specular = extensions->find("KHR_materials_specular")) {
        specular->erase("specularTexture");
        specular->erase("specularColorTexture");
    }
    if (own.contains("diffuseTexture")) {
        pbr.set("baseColorTexture", JsonText(own["diffuseTexture"].dump()));
    }
    if (own.contains("specularGlossinessTexture")) {
        const Json& info = own["specularGlossinessTexture"];
        patch_extension(material, "KHR_materials_specular", "specularColorTexture", info, Json());
        const double factor = std::clamp(own.value("glossinessFactor", 1.0), 0.0, 1.0);
        if (const std::optional<Json> texture = roughness_texture(info, factor)) {
            pbr.set("metallicRoughnessTexture", JsonText(texture->dump()));
        }
    }
}

}  // namespace lanthorn
