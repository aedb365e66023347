#include "engine/assets/gltf_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "engine/assets/gltf_compressed.h"
#include "engine/assets/gltf_format.h"
#include "engine/assets/uri.h"
#include "engine/assets/uri_file.h"

namespace lanthorn {

using nlohmann::json;

namespace {

// Removes, at every depth, what check_gltf() has not looked at and tinygltf would interpret. In extensions,
// integers beyond 32 bits become floats: tinygltf would cut them.
void reduce(json& value, bool in_extension = false) {
    if (in_extension && value.is_number_integer() && std::abs(value.get<double>()) > 2147483647.0) {
        value = value.get<double>();
    }
    if (value.is_object()) {
        for (const char* key : {"extras", "targets", "weights", "min", "max", "target"}) {
            value.erase(key);
        }
        if (const auto found = value.find("extensions"); found != value.end() && found->is_object()) {
            for (auto it = found->begin(); it != found->end();) {
                const bool known = it.key().starts_with("KHR_materials_") ||
                                   it.key() == "KHR_texture_transform" || it.key() == "KHR_lights_punctual";
                it = known ? std::next(it) : found->erase(it);
            }
        }
    }
    if (value.is_object()) {
        for (auto& [key, member] : value.items()) {
            reduce(member, in_extension || key == "extensions");
        }
    } else if (value.is_array()) {
        for (json& element : value) {
            reduce(element, in_extension);
        }
    }
}

// The elements of a top-level array, none if it is absent.
json& elements(json& document, const char* key) {
    static json none = json::array();
    const auto found = document.find(key);
    return found == document.end() ? none : *found;
}

// What tinygltf is to interpret. It would refuse index accessors without a buffer view, which are valid when
// they are sparse, and strides that are no multiple of 4, which are mended: the primitives' indices and the
// views' strides are left out here and set afterwards.
json reduced_document(const json& root) {
    json result;
    for (const char* key : {"asset", "extensions", "bufferViews", "accessors", "samplers", "textures",
                            "materials", "meshes", "cameras", "nodes", "scenes", "scene"}) {
        if (const auto found = root.find(key); found != root.end()) {
            result[key] = *found;
        }
    }
    reduce(result);
    for (json& accessor : elements(result, "accessors")) {
        if (component_count(accessor["type"].get_ref<const std::string&>()) == 0) {
            accessor["type"] = "SCALAR";  // never read: check_gltf() refuses its use
        }
    }
    for (json& view : elements(result, "bufferViews")) {
        view.erase("byteStride");
    }
    for (json& camera : elements(result, "cameras")) {
        if (camera["type"] != "perspective" && camera["type"] != "orthographic") {
            camera = {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}};
        }
    }
    for (json& mesh : elements(result, "meshes")) {
        for (json& primitive : mesh["primitives"]) {
            primitive.erase("indices");
        }
    }
    return result;
}

void restore_what_was_left_out(tinygltf::Model& model, const json& root) {
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        model.bufferViews[i].byteStride = root["bufferViews"][i].value("byteStride", std::size_t{0});
    }
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        const json& primitives = root["meshes"][m]["primitives"];
        for (std::size_t p = 0; p < model.meshes[m].primitives.size(); ++p) {
            model.meshes[m].primitives[p].indices = primitives[p].value("indices", -1);
        }
    }
}

void describe_images(tinygltf::Model& model, const json& root) {
    for (const json& source : root.value("images", json::array())) {
        tinygltf::Image& image = model.images.emplace_back();
        image.name = source.value("name", std::string());
        image.uri = source.value("uri", std::string());
        image.mimeType = source.value("mimeType", std::string());
        image.bufferView = source.value("bufferView", -1);
    }
}

// A buffer may leave its data to an extension that we do not read. The first one may be the BIN chunk.
bool is_somewhere(const GltfFile& file, std::size_t index) {
    return file.json["buffers"][index].contains("uri") || (index == 0 && file.chunk);
}

std::vector<std::uint8_t> read_buffer(GltfFile& file, std::size_t index) {
    const json& buffer = std::as_const(file.json)["buffers"][index];
    const std::string place = fmt::format("/buffers/{}", index);
    const std::uint64_t length = buffer["byteLength"];
    std::vector<std::uint8_t> bytes;
    if (!buffer.contains("uri")) {
        bytes = std::move(*file.chunk);
    } else {
        const std::string& uri = buffer["uri"].get_ref<const std::string&>();
        if (is_data_uri(uri)) {
            auto decoded = decode_data_uri(uri);
            if (!decoded) {
                file.refuse(place + "/uri",
                            "found a broken data URI, expected 'data:...;base64,' and base64 text");
            }
            bytes = std::move(*decoded);
        } else if (has_foreign_scheme(uri)) {
            file.refuse(place + "/uri",
                        fmt::format("found '{:.80}', expected a relative path or a data URI", uri));
        } else {
            const UriFile found = find_uri_file(file.folder, uri, file.allow_outside, *file.folders);
            if (!found.problem.empty()) {
                file.refuse(place + "/uri", found.problem);
            }
            if (!found.note.empty()) {
                file.note(place + "/uri", fmt::format("'{:.80}' {}", uri, found.note));
            }
            bytes = read_bytes(found.path, file.name, place + "/uri");
        }
    }
    if (bytes.size() < length) {
        file.refuse(place + "/byteLength",
                    fmt::format("the buffer holds {} bytes, expected {}", bytes.size(), length));
    }
    return bytes;
}

}  // namespace

tinygltf::Model build_model(GltfFile& file) {
    tinygltf::Model model;
    std::string error;
    if (!load_parsed(reduced_document(file.json), model, error)) {
        file.refuse("", error.empty() ? "cannot be interpreted as glTF 2.0" : error);
    }
    restore_what_was_left_out(model, file.json);
    describe_images(model, file.json);
    model.buffers.resize(file.json.value("buffers", json::array()).size());
    const json::json_pointer packed("/extensions/EXT_meshopt_compression");
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        const json& view = std::as_const(file.json)["bufferViews"][i];
        const std::size_t index = (view.contains(packed) ? view[packed] : view)["buffer"];
        auto& buffer = model.buffers[index];
        if (buffer.data.empty() && is_somewhere(file, index)) {
            buffer.data = read_buffer(file, index);
        }
    }
    decode_meshopt(file, model);
    decode_draco(file, model);
    return model;
}

}  // namespace lanthorn
