// What a GltfDocument holds, and what its parts share.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/assets/gltf_file.h"
#include "engine/assets/json_text.h"
#include "engine/assets/uri_file.h"
#include "lanthorn/assets/gltf_document.h"

namespace lanthorn {

struct NamedFile;

struct GltfDocument::State {
    std::string name = "glTF document";  // for messages
    std::filesystem::path source;        // empty: not read from a file
    bool is_glb = true;                  // the container it was read from
    bool allow_outside = false;          // whether files outside of its folder may be read
    std::shared_ptr<FolderNames> folders = std::make_shared<FolderNames>();  // that are read for such files
    std::string before, after;                                               // the JSON text around the root
    JsonText root{R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{}]})"};
    // Bytes of the buffers that have no URI, by index: the BIN chunk's and those that were added.
    std::map<std::size_t, std::shared_ptr<std::string>> held;  // copies of the document share them
    std::vector<GltfFile::Chunk> other_chunks;                 // of a .glb, BIN too if no buffer is in it
    std::map<std::pair<std::string, std::string>, std::size_t> shared;  // accessors by type and bytes
    // Textures of roughness that were made of glossiness, by texture and factor; none: it cannot be decoded.
    std::map<std::pair<std::size_t, double>, std::optional<std::size_t>> roughness;

    [[noreturn]] void refuse(std::string_view place, std::string_view problem) const;
    // What a caller gives as JSON; refused at `place` if it is none.
    nlohmann::json given_json(const std::string& place, std::string_view text) const;
    // /COLLECTION/INDEX. Refuses an index that is not in the file.
    JsonText& element(std::string_view collection, std::size_t index);
    const JsonText& element(std::string_view collection, std::size_t index) const;
    std::size_t count(std::string_view collection) const;
    JsonText& lights();  // the array, made if there is none
    std::size_t light_count() const;
    // Appends to a top-level array, which is made if there is none; the new index.
    std::size_t append(std::string_view collection, JsonText value);
    void use_extension(std::string_view extension);

    // Refuses a number outside of low..high, and one that is not finite.
    void expect_in(double value, double low, double high, const std::string& place) const;
    template <typename V>
    void expect_all_in(const V& v, double low, double high, const std::string& place) const {
        for (int i = 0; i < static_cast<int>(v.length()); ++i) {
            expect_in(v[i], low, high, place + '/' + std::to_string(i));
        }
    }

    // gltf_document_nodes.cpp
    void set_reference(std::size_t node, std::string_view key, std::uint32_t index,
                       std::string_view collection, std::size_t size);
    JsonText* scene();
    void detach(std::size_t node);                  // from its parent and from all scenes
    std::size_t parent_of(std::size_t node) const;  // kNone: none

    // gltf_document_parts.cpp
    void patch_camera(JsonText& target, const Camera& camera, const std::string& place) const;
    void patch_light(JsonText& target, const Light& light, const std::string& place) const;

    std::size_t add_image(const Image& image);

    // gltf_document_motion.cpp
    void expect_keys(const AnimationChannel& channel, const std::string& place) const;
    // Makes the objects that hold the material's property at the end of `path`, of nothing but defaults,
    // where there are none: pointers lead to what is there. Textures are left to who has one.
    void make_owners(std::size_t material, std::string_view path);

    // gltf_document_glossiness.cpp
    std::vector<std::uint8_t> image_bytes(const JsonText& image) const;
    // A texture of roughness for what `info` refers to, whose alpha times `factor` is glossiness.
    std::optional<nlohmann::json> roughness_texture(const nlohmann::json& info, double factor);
    // Textures of the extension become those of the format and of KHR_materials_specular; its factors are
    // for patch_material().
    void restate_glossiness(JsonText& material);

    // gltf_document_materials.cpp
    void patch_material(JsonText& target, const Material& material, const std::string& place);
    void patch_extension(JsonText& owner, const char* extension, const char* key, const nlohmann::json& value,
                         const nlohmann::json& fallback);

    // gltf_document_buffers.cpp
    // A new view of `bytes`, at a multiple of four; `target` 0: none.
    std::size_t add_view(const std::string& bytes, int target);
    std::size_t add_accessor(const std::string& bytes, int target, const char* type, int component,
                             std::size_t count, nlohmann::json members = nlohmann::json::object());
    // The same, but an accessor of the same bytes and type is used again.
    std::size_t share_accessor(const std::string& bytes, int target, const char* type, int component,
                               std::size_t count, const nlohmann::json& members = nlohmann::json::object());
    // The bytes that buffer `index` has by its byteLength, from wherever it has them. Refuses what cannot be
    // read.
    std::string buffer_bytes(std::size_t index) const;

    // gltf_document_images.cpp
    // The bytes of a named image; none with a warning, as GltfDocument::write words it.
    std::optional<std::string> file_bytes(const NamedFile& file, std::vector<std::string>& warnings) const;
    // Buffer 0 becomes one without a URI, those behind it data URIs.
    void hold_buffers();
};

// The value parsed. Integers may be written as 4.0.
nlohmann::json parsed(const JsonText& text);
// The member `key` parsed; null if there is none.
nlohmann::json parsed(const JsonText& object, std::string_view key);
std::uint64_t index_at(const JsonText& object, std::string_view key, std::uint64_t fallback);

// The shortest decimal that reads back as `value`, as a double: 0.1f is written 0.1. No -0.
double plain_number(float value);
double plain_number(double value);
// A vector or quaternion-as-vec4 as an array of such numbers.
template <typename V>
nlohmann::json plain_numbers(const V& v) {
    nlohmann::json result = nlohmann::json::array();
    for (int i = 0; i < static_cast<int>(v.length()); ++i) {
        result.push_back(plain_number(v[i]));
    }
    return result;
}

// Sets `object[key]` unless it is there and means the same: numbers and arrays of them are compared as 32-bit
// floats, or as doubles where `exact`. An absent member means `fallback` (null: nothing).
void patch(JsonText& object, std::string_view key, const nlohmann::json& value,
           const nlohmann::json& fallback, bool exact = false);
// The member, an object, made if there is none.
JsonText& object_at(JsonText& object, std::string_view key);

}  // namespace lanthorn
