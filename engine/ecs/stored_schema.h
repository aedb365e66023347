// What components and resources were declared when something was stored, so that a program with other
// declarations finds values by their names.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/ecs/registry.h"

namespace lanthorn::ecs::detail {

struct StoredField;

// As ValueType, but of a program that is not there any more.
struct StoredType {
    ValueKind kind = ValueKind::opaque;
    std::size_t size = 0;             // bytes, of scalars
    bool is_signed = false;           // of integers
    bool optional = false;            // of lists
    std::size_t numbers = 0;          // of ValueKind::numbers
    std::vector<StoredType> element;  // one, of numbers and lists
    std::vector<StoredField> fields;  // of structures
};

struct StoredField {
    std::string name;
    std::vector<std::string> choices;
    StoredType type;
};

struct StoredSchema {
    struct Declared {
        std::string name;
        StoredType type;
    };
    std::vector<Declared> components, resources;  // in the order of declaration
};

// As JSON.
std::string schema_text(const Registry& registry);
// Throws InputError or nlohmann's exceptions for text that schema_text() did not write.
StoredSchema read_schema(std::string_view text);

// Takes stored values apart and puts what has a namesake into living ones. Numbers become the type and come
// into the range that is declared now, enumerations go by their choices' names. What has no namesake, or one
// of another kind, is passed over and noted.
class StoredReader {
  public:
    explicit StoredReader(std::vector<std::string>& left_out) : left_out_(left_out) {}

    // A whole value; `to` may be null: then it is passed over. Fields that were not stored stay. False: the
    // bytes end too early or cannot be such a value.
    bool read(const StoredType& from, std::span<const std::byte>& bytes, const ValueType* to, void* value,
              const std::string& place);
    // Noted once, however often it is met.
    void leave_out(const std::string& place);

  private:
    using Bytes = std::span<const std::byte>;
    struct Target {
        const Field* field;
        const ValueType* type;  // null: nothing takes it
        void* value;
    };
    bool read(const StoredField& from, Bytes& bytes, Target to, const std::string& place);
    bool read_scalar(const StoredField& from, const StoredType& type, Bytes& bytes, Target to,
                     const std::string& place);
    bool read_text(Bytes& bytes, Target to, const std::string& place);
    bool read_numbers(const StoredField& from, const StoredType& type, Bytes& bytes, Target to,
                      const std::string& place);
    bool read_list(const StoredField& from, const StoredType& type, Bytes& bytes, Target to,
                   const std::string& place);
    bool read_structure(const StoredType& type, Bytes& bytes, Target to, const std::string& place);
    bool read_any(const StoredField& from, const StoredType& type, Bytes& bytes, Target to,
                  const std::string& place);
    // The target if it is of that kind; else none, which is noted.
    Target of_kind(ValueKind kind, Target to, const std::string& place);

    std::vector<std::string>& left_out_;
};

}  // namespace lanthorn::ecs::detail
