// Numbers and bytes of a recording's file, one behind the other.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "lanthorn/core/error.h"

namespace lanthorn::replay {

static_assert(std::endian::native == std::endian::little, "recordings are little-endian");

// Of a sensor reading in any version: sensor, age and value.
inline constexpr std::size_t kReadingBytes = sizeof(std::uint32_t) + sizeof(std::uint32_t) + sizeof(float);

class Writer {
  public:
    template <class T>
    void put(T value) {
        text_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void put_bytes(std::span<const std::byte> from) {
        text_.append(reinterpret_cast<const char*>(from.data()), from.size());
    }
    void put_bytes(std::string_view from) { text_ += from; }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

// Thrown where the bytes end too early.
struct EndsHere {};

class Reader {
  public:
    // `begin`: where in the file `bytes` are. `file` must outlive this.
    Reader(const std::string& file, std::span<const std::byte> bytes, std::size_t begin = 0)
        : file_(file), bytes_(bytes), begin_(begin) {}

    template <class T>
    T get() {
        T value;
        std::memcpy(&value, take(sizeof value).data(), sizeof value);
        return value;
    }
    // Throws EndsHere where there are not as many.
    std::span<const std::byte> take(std::size_t count) {
        if (count > left()) {
            throw EndsHere{};
        }
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }
    std::span<const std::byte> taken_since(std::size_t from) const {
        return bytes_.subspan(from, at_ - from);
    }
    std::size_t left() const { return bytes_.size() - at_; }
    std::size_t at() const { return begin_ + at_; }  // in the file
    const std::string& file() const { return file_; }
    [[noreturn]] void fail(const std::string& problem) const {
        throw InputError(file_, fmt::format("byte {}", at()), problem);
    }

  private:
    const std::string& file_;
    std::span<const std::byte> bytes_;
    std::size_t begin_;
    std::size_t at_ = 0;
};

}  // namespace lanthorn::replay
