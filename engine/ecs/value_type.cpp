#include "lanthorn/ecs/value_type.h"

#include <cstring>

#include "engine/ecs/number_text.h"

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

std::string range_text(const Field& field) {
    const bool low = field.lower > std::numeric_limits<double>::lowest();
    const bool high = field.upper < std::numeric_limits<double>::max();
    const std::string lower = number_text(field.lower);
    const std::string upper = number_text(field.upper);
    if (low && high) {
        return field.lower_excluded ? " more than " + lower + ", at most " + upper
                                    : " from " + lower + " to " + upper;
    }
    if (low) {
        return field.lower_excluded ? " more than " + lower : " of " + lower + " or more";
    }
    return high ? " of at most " + upper : "";
}

std::string numbers_text(std::size_t count) {
    constexpr std::array<const char*, 5> kWords = {"no", "one", "two", "three", "four"};
    return (count < kWords.size() ? kWords[count] : std::to_string(count)) + std::string(" numbers");
}

std::string expectation_of(const Field& field, const ValueType& type) {
    const std::string range = range_text(field);
    const std::string unit = field.unit.empty() ? "" : " " + field.unit;
    switch (type.kind) {
        case ValueKind::boolean:
            return "true or false";
        case ValueKind::integer:
            return "an integer" + range + unit;
        case ValueKind::real:
            return "a number" + range + unit;
        case ValueKind::enumeration: {
            std::string names;
            for (const std::string& choice : field.choices) {
                names += (names.empty() ? "'" : ", '") + choice + "'";
            }
            return "one of " + names;
        }
        case ValueKind::text:
            return "a text";
        case ValueKind::numbers:
            return numbers_text(type.numbers) + range + unit;
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
