#include "tests/unit/assets/gltf_builder.h"

#include <unistd.h>

#include <atomic>
#include <fstream>

namespace lanthorn {

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

void append_u32(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<char>(value >> shift & 0xff));
    }
}

std::string padded(std::string bytes, char with) {
    bytes.resize((bytes.size() + 3) / 4 * 4, with);
    return bytes;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    static std::atomic<int> counter{0};
    path_ = fs::temp_directory_path() /
            ("lanthorn-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
    fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

fs::path TemporaryFolder::write(const std::string& name, const std::string& bytes) const {
    const fs::path path = path_ / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

GltfBuilder::GltfBuilder() {
    json["asset"] = {{"version", "2.0"}};
}

int GltfBuilder::add_view(const std::string& bytes, int stride) {
    buffer = padded(buffer, '\0');
    nlohmann::json view = {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}};
    if (stride != 0) {
        view["byteStride"] = stride;
    }
    json["bufferViews"].push_back(view);
    buffer += bytes;
    return static_cast<int>(json["bufferViews"].size()) - 1;
}

int GltfBuilder::add_accessor(int view, int component_type, const std::string& type, std::size_t count) {
    nlohmann::json accessor = {{"componentType", component_type}, {"type", type}, {"count", count}};
    if (view >= 0) {
        accessor["bufferView"] = view;
    }
    json["accessors"].push_back(accessor);
    return static_cast<int>(json["accessors"].size()) - 1;
}

nlohmann::json& GltfBuilder::add_primitive(const nlohmann::json& attributes, int indices) {
    nlohmann::json primitive = {{"attributes", attributes}};
    if (indices >= 0) {
        primitive["indices"] = indices;
    }
    json["meshes"].push_back({{"primitives", {primitive}}});
    json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
    return json["meshes"].back()["primitives"][0];
}

nlohmann::json& GltfBuilder::add_triangle() {
    return add_primitive({{"POSITION", add_vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})}});
}

int GltfBuilder::add_material(const nlohmann::json& material) {
    json["materials"].push_back(material);
    return static_cast<int>(json["materials"].size()) - 1;
}

int GltfBuilder::add_texture(const std::string& png) {
    json["images"].push_back({{"bufferView", add_view(png)}, {"mimeType", "image/png"}});
    json["textures"].push_back({{"source", json["images"].size() - 1}});
    return static_cast<int>(json["textures"].size()) - 1;
}

nlohmann::json GltfBuilder::with_buffer(bool data_uri) const {
    nlohmann::json document = json;
    if (!buffer.empty() && document.is_object() && !document.contains("buffers")) {
        document["buffers"] = {{{"byteLength", buffer.size()}}};
        if (data_uri) {
            document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(buffer);
        }
    }
    return document;
}

std::string GltfBuilder::gltf() const {
    return with_buffer(true).dump();
}

std::string GltfBuilder::glb() const {
    const std::string text = padded(with_buffer(false).dump(), ' ');
    const std::string binary = padded(buffer, '\0');
    std::string bytes = "glTF";
    append_u32(bytes, 2);
    append_u32(bytes,
               static_cast<std::uint32_t>(12 + 8 + text.size() + (binary.empty() ? 0 : 8 + binary.size())));
    append_u32(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += "JSON" + text;
    if (!binary.empty()) {
        append_u32(bytes, static_cast<std::uint32_t>(binary.size()));
        bytes += std::string("BIN\0", 4) + binary;
    }
    return bytes;
}

std::string base64(const std::string& bytes) {
    static const char* alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text.push_back(i + k <= bytes.size() ? alphabet[bits >> (18 - 6 * k) & 63] : '=');
        }
    }
    return text;
}

}  // namespace lanthorn
