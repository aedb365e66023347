// A .glb in the making: its JSON and its binary chunk.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace lanthorn::scene_generator {

// The shortest decimal that reads back as `value`, as a double: 0.1f is written 0.1.
double number(float value);

void append_u16(std::string& out, std::uint16_t value);
void append_u32(std::string& out, std::uint32_t value);
void append_f32(std::string& out, float value);

// Fills up to a multiple of four bytes.
void pad(std::string& out, char with);

class GlbBuffer {
  public:
    static constexpr int kFloat = 5126, kShort = 5123, kInt = 5125;
    static constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

    nlohmann::json root;

    // Appends to the binary chunk; the new buffer view's index. `target` 0: none.
    std::size_t add_view(const std::string& bytes, int target);
    // A new accessor with a view of its own.
    std::size_t add_accessor(const std::string& bytes, int target, const char* type, int component,
                             std::size_t count);
    // The same, but an accessor of the same bytes and type is used again.
    std::size_t share_accessor(const std::string& bytes, int target, const char* type, int component,
                               std::size_t count);

    // The whole file.
    std::string bytes() const;

  private:
    std::string bin_;
    std::map<std::pair<std::string, std::string>, std::size_t> shared_;  // by type and bytes
};

}  // namespace lanthorn::scene_generator
