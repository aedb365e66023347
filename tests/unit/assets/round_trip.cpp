#include "tests/unit/assets/round_trip.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/assets/uri.h"
#include "lanthorn/assets/gltf_document.h"
#include "lanthorn/assets/gltf_import.h"
#include "tests/unit/assets/same_scene.h"

namespace lanthorn {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

std::string bytes_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::uint32_t u32_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    }
    return value;
}

// A glTF file read without the engine.
struct Plain {
    ordered_json json;
    std::optional<std::string> chunk;
    fs::path folder;

    explicit Plain(const fs::path& path) : folder(path.parent_path()) {
        const std::string bytes = bytes_of(path);
        if (!bytes.starts_with("glTF")) {
            json = ordered_json::parse(bytes);
            return;
        }
        for (std::size_t at = 12; at < u32_at(bytes, 8); at += 8 + u32_at(bytes, at)) {
            const std::string content = bytes.substr(at + 8, u32_at(bytes, at));
            if (bytes.substr(at + 4, 4) == "JSON") {
                json = ordered_json::parse(content);
            } else if (bytes.substr(at + 4, 4) == std::string("BIN\0", 4)) {
                chunk = content;
            }
        }
    }

    // Of a buffer or image; nothing where there is no such file.
    std::optional<std::string> held_by(const ordered_json& owner, bool is_first_buffer) const {
        if (!owner.contains("uri")) {
            return is_first_buffer ? chunk : std::nullopt;
        }
        const std::string uri = owner["uri"];
        if (is_data_uri(uri)) {
            const auto bytes = decode_data_uri(uri);
            return bytes ? std::optional(std::string(bytes->begin(), bytes->end())) : std::nullopt;
        }
        const fs::path path = folder / percent_decoded(uri);
        return fs::is_regular_file(path) ? std::optional(bytes_of(path)) : std::nullopt;
    }
};

void expect_same_bytes(const Plain& a, const Plain& b) {
    for (const char* key : {"buffers", "images"}) {
        const ordered_json owners = a.json.value(key, ordered_json::array());
        for (std::size_t i = 0; i < owners.size(); ++i) {
            const bool is_buffer = std::string_view(key) == "buffers";
            auto one = a.held_by(owners[i], is_buffer && i == 0);
            auto other = b.held_by(b.json[key][i], is_buffer && i == 0);
            ASSERT_EQ(one.has_value(), other.has_value()) << key << " " << i;
            if (one && is_buffer) {
                one->resize(owners[i]["byteLength"]);
                other->resize(owners[i]["byteLength"]);
            }
            EXPECT_TRUE(one == other) << key << " " << i << " differ";
        }
    }
}

// Whether it is no .glb, or one that ends where it says and has chunks at multiples of four bytes.
bool is_whole(const std::string& bytes) {
    return !bytes.starts_with("glTF") || (u32_at(bytes, 8) == bytes.size() && u32_at(bytes, 12) % 4 == 0);
}

ordered_json without_place_of_buffer_0(ordered_json json) {
    if (json.contains("buffers")) {
        json["buffers"][0].erase("uri");
    }
    return json;
}

void expect_same(const fs::path& a, const fs::path& b) {
    SCOPED_TRACE(b);
    const Plain one(a);
    const Plain other(b);
    EXPECT_EQ(without_place_of_buffer_0(one.json), without_place_of_buffer_0(other.json));
    expect_same_bytes(one, other);
    expect_same_scene(import_gltf(a), import_gltf(b));
}

}  // namespace

void expect_lossless(const fs::path& file, const fs::path& folder) {
    const bool is_glb = bytes_of(file).starts_with("glTF");
    const char* own = is_glb ? ".glb" : ".gltf";
    const char* other = is_glb ? ".gltf" : ".glb";
    const fs::path same = folder / "same" / (std::string("a") + own);
    const fs::path there = folder / "there" / (std::string("a") + other);
    const fs::path back = folder / "back" / (std::string("a") + own);
    for (const fs::path& path : {same, there, back}) {
        fs::create_directories(path.parent_path());
    }
    GltfDocument::open(file).write(same);
    EXPECT_TRUE(!is_whole(bytes_of(file)) || bytes_of(same) == bytes_of(file))
        << "the same container has other bytes";
    expect_same(file, same);
    GltfDocument::open(file).write(there);
    expect_same(file, there);
    GltfDocument::open(there).write(back);
    expect_same(file, back);
}

}  // namespace lanthorn
