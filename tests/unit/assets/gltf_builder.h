// Small glTF files made by hand, for tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/unit/assets/image_files.h"  // most who build a file put images into it

namespace lanthorn {

// A folder that is removed again.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const;

  private:
    std::filesystem::path path_;
};

// A glTF document with one buffer. `json` may be edited at will before it is written.
class GltfBuilder {
  public:
    GltfBuilder();

    nlohmann::json json;
    std::string buffer;

    // A buffer view of `bytes`; returns its index.
    int add_view(const std::string& bytes, int stride = 0);
    // An accessor of `count` elements in a view, or without one.
    int add_accessor(int view, int component_type, const std::string& type, std::size_t count);
    // An accessor with its own view.
    template <typename T>
    int add(const std::vector<T>& values, const std::string& type, std::size_t components) {
        return add_accessor(add_view(bytes_of(values)), component_type<T>(), type,
                            values.size() / components);
    }
    int add_vec3(const std::vector<float>& values) { return add(values, "VEC3", 3); }
    template <typename T>
    int add_scalars(const std::vector<T>& values) {
        return add(values, "SCALAR", 1);
    }
    // A mesh of one primitive and a root node that shows it; returns the primitive.
    nlohmann::json& add_primitive(const nlohmann::json& attributes, int indices = -1);
    // The triangle (0,0,0) (1,0,0) (0,1,0) as a mesh in a node.
    nlohmann::json& add_triangle();
    // Material `extra` merged over an empty one; returns its index.
    int add_material(const nlohmann::json& material);
    // A PNG in the buffer as image and texture; returns the texture's index.
    int add_texture(const std::string& png);

    std::string glb() const;
    std::string gltf() const;  // the buffer as a data URI

    template <typename T>
    static std::string bytes_of(const std::vector<T>& values) {
        std::string bytes(values.size() * sizeof(T), '\0');
        if (!values.empty()) {
            std::memcpy(bytes.data(), values.data(), bytes.size());
        }
        return bytes;
    }

  private:
    template <typename T>
    static constexpr int component_type() {
        if constexpr (std::is_same_v<T, float>) {
            return 5126;
        } else if constexpr (sizeof(T) == 4) {
            return 5125;
        } else if constexpr (sizeof(T) == 2) {
            return std::is_signed_v<T> ? 5122 : 5123;
        } else {
            return std::is_signed_v<T> ? 5120 : 5121;
        }
    }
    nlohmann::json with_buffer(bool data_uri) const;
};

std::string base64(const std::string& bytes);

}  // namespace lanthorn
