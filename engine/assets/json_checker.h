// Typed access to JSON with the pointer of the culprit in every complaint.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>

#include "engine/assets/gltf_file.h"

namespace lanthorn {

enum class Need { optional, required };

// A JSON value of a GltfFile and its JSON pointer (RFC 6901). Every check throws InputError naming that
// pointer. An absent optional member is no error; the checks return whether the member is there.
class JsonPlace {
  public:
    JsonPlace(GltfFile& file, nlohmann::json& value, std::string pointer)
        : file_(&file), value_(&value), pointer_(std::move(pointer)) {}

    nlohmann::json& value() const { return *value_; }
    const std::string& pointer() const { return pointer_; }
    const GltfFile& file() const { return *file_; }
    std::string pointer_to(std::string_view key) const;
    bool has(std::string_view key) const { return value_->contains(key); }
    // Tells of something that is mended (GltfFile::note).
    void note(std::string_view key, std::string_view text) const { file_->note(pointer_to(key), text); }

    [[noreturn]] void refuse(std::string_view problem) const;
    [[noreturn]] void refuse(std::string_view key, std::string_view problem) const;

    void expect_object() const;
    bool boolean(std::string_view key, Need need = Need::optional) const;
    bool string(std::string_view key, Need need = Need::optional,
                std::initializer_list<std::string_view> allowed = {}) const;
    // A number that a 32-bit float can hold.
    bool number(std::string_view key, Need need = Need::optional) const;
    // An array of exactly `size` such numbers.
    bool numbers(std::string_view key, std::size_t size, Need need = Need::optional) const;
    // An array of any size of such numbers.
    bool number_list(std::string_view key, Need need = Need::optional) const;
    bool integer(std::string_view key, std::uint64_t low, std::uint64_t high,
                 Need need = Need::optional) const;
    // An index into the root's array `collection`.
    bool index(std::string_view key, std::string_view collection, Need need = Need::optional) const;
    // An array of indices into the root's array `collection`.
    bool indices(std::string_view key, std::string_view collection) const;
    // Calls `check` with the member, which must be an object.
    bool object(std::string_view key, const std::function<void(const JsonPlace&)>& check,
                Need need = Need::optional) const;
    // Calls `check` with each element of the member, an array of objects.
    bool objects(std::string_view key, const std::function<void(const JsonPlace&)>& check,
                 Need need = Need::optional) const;

    // The member as an integer (checked before) or `fallback` if it is absent.
    std::uint64_t get(std::string_view key, std::uint64_t fallback = 0) const;

  private:
    void expect_floats(std::string_view key, const nlohmann::json& array) const;
    nlohmann::json* member(std::string_view key, Need need) const;

    GltfFile* file_;
    nlohmann::json* value_;
    std::string pointer_;
};

}  // namespace lanthorn
