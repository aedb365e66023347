#include "tools/scene_generator/glb_buffer.h"

#include <charconv>
#include <cstring>

namespace lanthorn::scene_generator {

using nlohmann::json;

double number(float value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    double result = 0;
    std::from_chars(text, end, result);
    return result == 0 ? 0 : result;  // no -0
}

void append_u16(std::string& out, std::uint16_t value) {
    out.push_back(static_cast<char>(value));
    out.push_back(static_cast<char>(value >> 8));
}

void append_u32(std::string& out, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        out.push_back(static_cast<char>(value >> shift));
    }
}

void append_f32(std::string& out, float value) {
    std::uint32_t bits;
    const float plain = value == 0 ? 0.0f : value;
    std::memcpy(&bits, &plain, sizeof bits);
    append_u32(out, bits);
}

void pad(std::string& out, char with) {
    out.resize((out.size() + 3) / 4 * 4, with);
}

std::size_t GlbBuffer::add_view(const std::string& bytes, int target) {
    json view = {{"buffer", 0}, {"byteLength", bytes.size()}, {"byteOffset", bin_.size()}};
    if (target != 0) {
        view["target"] = target;
    }
    bin_ += bytes;
    pad(bin_, 0);
    root["bufferViews"].push_back(view);
    return root["bufferViews"].size() - 1;
}

std::size_t GlbBuffer::add_accessor(const std::string& bytes, int target, const char* type, int component,
                                    std::size_t count) {
    root["accessors"].push_back({{"bufferView", add_view(bytes, target)},
                                 {"componentType", component},
                                 {"count", count},
                                 {"type", type}});
    return root["accessors"].size() - 1;
}

std::size_t GlbBuffer::share_accessor(const std::string& bytes, int target, const char* type, int component,
                                      std::size_t count) {
    const auto [known, added] = shared_.try_emplace(
        {std::string(type) + std::to_string(component) + ' ' + std::to_string(target), bytes}, 0);
    if (added) {
        known->second = add_accessor(bytes, target, type, component, count);
    }
    return known->second;
}

std::string GlbBuffer::bytes() const {
    json whole = root;
    if (!bin_.empty()) {
        whole["buffers"] = {{{"byteLength", bin_.size()}}};
    }
    std::string text = whole.dump();
    pad(text, ' ');
    std::string out = "glTF";
    append_u32(out, 2);
    append_u32(out, static_cast<std::uint32_t>(12 + 8 + text.size() + (bin_.empty() ? 0 : 8 + bin_.size())));
    append_u32(out, static_cast<std::uint32_t>(text.size()));
    out += "JSON" + text;
    if (!bin_.empty()) {
        append_u32(out, static_cast<std::uint32_t>(bin_.size()));
        out += std::string("BIN\0", 4) + bin_;
    }
    return out;
}

}  // namespace lanthorn::scene_generator
