#include "lanthorn/ecs/value_type.h"

#include <cstring>

namespace lanthorn::ecs {
namespace {

template <class T>
double read(const void* value) {
    T result;
    std::memcpy(&result, value, sizeof result);
    return static_cast<double>(result);
}

template <class T>
void write(void* value, double number) {
    const T result = static_cast<T>(number);
    std::memcpy(value, &result, sizeof result);
}

std::string numbers_text(std::size_t count) {
    constexpr std::array<const char*, 5> kWords = {"no", "one", "two", "three", "four"};
    return (count < kWords.size() ? kWords[count] : std::to_string(count)) + std::string(" numbers");
}

std::string expectation_of(const Field& field, const ValueType& type) {
    switch (type.kind) {
        case ValueKind::boolean:
            return "true or false";
        case ValueKind::integer:
            return field.described("an integer");
        case ValueKind::real:
            return field.described("a number");
        case ValueKind::enumeration:
            return field.one_of();
        case ValueKind::text:
            return "a text";
        case ValueKind::numbers:
            return field.described(numbers_text(type.numbers));
        case ValueKind::entity:
            return "the name of an entity, or null";
        case ValueKind::list:
            return type.optional ? expectation_of(field, *type.element) + ", or null"
                                 : "an array, each of it " + expectation_of(field, *type.element);
        case ValueKind::structure:
            return "an object";
        case ValueKind::opaque:
            break;
    }
    return "nothing: it cannot be written";
}

}  // namespace

std::string Field::expectation() const {
    return expectation_of(*this, *type);
}

double number_of(const ValueType& type, const void* value) {
    if (type.kind == ValueKind::real) {
        return type.size == sizeof(float) ? read<float>(value) : read<double>(value);
    }
    switch (type.size) {
        case 1:
            return type.is_signed ? read<std::int8_t>(value) : read<std::uint8_t>(value);
        case 2:
            return type.is_signed ? read<std::int16_t>(value) : read<std::uint16_t>(value);
        case 4:
            return type.is_signed ? read<std::int32_t>(value) : read<std::uint32_t>(value);
        default:
            return type.is_signed ? read<std::int64_t>(value) : read<std::uint64_t>(value);
    }
}

void set_number(const ValueType& type, void* value, double number) {
    if (type.kind == ValueKind::real) {
        return type.size == sizeof(float) ? write<float>(value, number) : write<double>(value, number);
    }
    switch (type.size) {
        case 1:
            return type.is_signed ? write<std::int8_t>(value, number) : write<std::uint8_t>(value, number);
        case 2:
            return type.is_signed ? write<std::int16_t>(value, number) : write<std::uint16_t>(value, number);
        case 4:
            return type.is_signed ? write<std::int32_t>(value, number) : write<std::uint32_t>(value, number);
        default:
            return type.is_signed ? write<std::int64_t>(value, number) : write<std::uint64_t>(value, number);
    }
}

}  // namespace lanthorn::ecs
