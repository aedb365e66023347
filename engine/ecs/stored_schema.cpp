#include "engine/ecs/stored_schema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"

namespace lanthorn::ecs::detail {

using nlohmann::json;

namespace {

constexpr std::size_t kMostNumbers = 16;  // of a matrix

constexpr std::array kKinds{"bool",    "integer", "real", "choice",    "text",
                            "numbers", "entity",  "list", "structure", "opaque"};

json to_json(const ValueType& type, const std::vector<std::string>& choices) {
    json result{{"kind", kKinds.at(static_cast<std::size_t>(type.kind))}};
    switch (type.kind) {
        case ValueKind::integer:
            result["signed"] = type.is_signed;
            [[fallthrough]];
        case ValueKind::boolean:
        case ValueKind::real:
        case ValueKind::entity:
            result["size"] = type.size;
            break;
        case ValueKind::enumeration:
            result["size"] = type.size;
            result["choices"] = choices;
            break;
        case ValueKind::numbers:
            result["numbers"] = type.numbers;
            result["of"] = to_json(*type.element, choices);
            break;
        case ValueKind::list:
            result["optional"] = type.optional;
            result["of"] = to_json(*type.element, choices);
            break;
        case ValueKind::structure:
            result["fields"] = json::array();
            for (const Field& field : type.fields) {
                result["fields"].push_back(
                    {{"name", field.name}, {"type", to_json(*field.type, field.choices)}});
            }
            break;
        case ValueKind::text:
        case ValueKind::opaque:
            break;
    }
    return result;
}

StoredType stored_type(const json& from, std::vector<std::string>& choices) {
    StoredType type;
    const auto kind = std::ranges::find(kKinds, from.at("kind").get<std::string>());
    if (kind == kKinds.end()) {
        throw InputError("found a kind of value that is not known");
    }
    type.kind = static_cast<ValueKind>(kind - kKinds.begin());
    type.size = from.value("size", std::size_t{0});
    type.is_signed = from.value("signed", false);
    type.optional = from.value("optional", false);
    type.numbers = from.value("numbers", std::size_t{0});
    const bool is_scalar = type.kind == ValueKind::boolean || type.kind == ValueKind::integer ||
                           type.kind == ValueKind::real || type.kind == ValueKind::entity ||
                           type.kind == ValueKind::enumeration;
    if ((is_scalar && (type.size < 1 || type.size > sizeof(std::uint64_t))) || type.numbers > kMostNumbers) {
        throw InputError("found a value of a size that no type has");
    }
    if (from.contains("choices")) {
        choices = from["choices"].get<std::vector<std::string>>();
    }
    if (type.kind == ValueKind::numbers || type.kind == ValueKind::list) {
        type.element.push_back(stored_type(from.at("of"), choices));
    }
    if (type.kind == ValueKind::structure) {
        for (const json& own : from.at("fields")) {
            StoredField field;
            field.name = own.at("name").get<std::string>();
            field.type = stored_type(own.at("type"), field.choices);
            type.fields.push_back(std::move(field));
        }
    }
    return type;
}

template <class Declared>
json to_json(const std::deque<Declared>& all) {
    json result = json::array();
    for (const Declared& type : all) {
        result.push_back({{"name", type.name}, {"type", to_json(*type.value, {})}});
    }
    return result;
}

std::vector<StoredSchema::Declared> stored(const json& all) {
    std::vector<StoredSchema::Declared> result;
    for (const json& type : all) {
        std::vector<std::string> choices;
        result.push_back({type.at("name").get<std::string>(), stored_type(type.at("type"), choices)});
    }
    return result;
}

// The described value of a scalar's bytes, which are the machine's own.
double number_of(const StoredType& type, const std::array<std::byte, 8>& bytes) {
    ValueType as;
    as.kind = type.kind;
    as.size = type.size;
    as.is_signed = type.is_signed;
    return ecs::number_of(as, bytes.data());
}

// Into what the type can hold and the field allows; whole for integers.
double fitted(const Field& field, const ValueType& type, double number) {
    number = std::clamp(number, field.lower, field.upper);
    if (type.kind == ValueKind::integer) {
        const int bits = static_cast<int>(8 * type.size) - (type.is_signed ? 1 : 0);
        const double most = std::nextafter(std::ldexp(1.0, bits), 0.0);
        number = std::clamp(std::floor(number), type.is_signed ? -std::ldexp(1.0, bits) : 0.0, most);
    } else if (type.size == sizeof(float)) {
        constexpr double kMost = std::numeric_limits<float>::max();
        number = std::isinf(number) ? number : std::clamp(number, -kMost, kMost);
    }
    return number;
}

bool is_number(ValueKind kind) {
    return kind == ValueKind::integer || kind == ValueKind::real;
}

bool take_count(std::span<const std::byte>& bytes, std::uint64_t& count) {
    if (bytes.size() < sizeof count) {
        return false;
    }
    std::memcpy(&count, bytes.data(), sizeof count);
    bytes = bytes.subspan(sizeof count);
    return count <= bytes.size();  // every element has a byte at least
}

}  // namespace

std::string schema_text(const Registry& registry) {
    return json{{"components", to_json(registry.components())}, {"resources", to_json(registry.resources())}}
        .dump();
}

StoredSchema read_schema(std::string_view text) {
    const json root = parse_json(text, "schema");
    return {stored(root.at("components")), stored(root.at("resources"))};
}

void StoredReader::leave_out(const std::string& place) {
    if (std::ranges::find(left_out_, place) == left_out_.end()) {
        left_out_.push_back(place);
    }
}

StoredReader::Target StoredReader::of_kind(ValueKind kind, Target to, const std::string& place) {
    if (to.type != nullptr && to.type->kind != kind) {
        leave_out(place);
        to.type = nullptr;
    }
    return to;
}

bool StoredReader::read(const StoredType& from, Bytes& bytes, const ValueType* to, void* value,
                        const std::string& place) {
    return from.kind == ValueKind::opaque || read_structure(from, bytes, {nullptr, to, value}, place);
}

bool StoredReader::read(const StoredField& from, Bytes& bytes, Target to, const std::string& place) {
    return read_any(from, from.type, bytes, to, place);
}

bool StoredReader::read_any(const StoredField& from, const StoredType& type, Bytes& bytes, Target to,
                            const std::string& place) {
    switch (type.kind) {
        case ValueKind::text:
            return read_text(bytes, to, place);
        case ValueKind::numbers:
            return read_numbers(from, type, bytes, to, place);
        case ValueKind::list:
            return read_list(from, type, bytes, to, place);
        case ValueKind::structure:
            return read_structure(type, bytes, of_kind(ValueKind::structure, to, place), place);
        case ValueKind::opaque:
            return true;
        default:
            return read_scalar(from, type, bytes, to, place);
    }
}

bool StoredReader::read_scalar(const StoredField& from, const StoredType& type, Bytes& bytes, Target to,
                               const std::string& place) {
    std::array<std::byte, 8> raw{};
    if (bytes.size() < type.size) {
        return false;
    }
    std::memcpy(raw.data(), bytes.data(), type.size);
    bytes = bytes.subspan(type.size);
    if (type.kind == ValueKind::boolean && raw[0] > std::byte{1}) {
        return false;
    }
    if (to.type == nullptr) {
        return true;
    }
    const bool as_number = is_number(type.kind) && is_number(to.type->kind);
    if (!as_number && type.kind != to.type->kind) {
        leave_out(place);
        return true;
    }
    if (type.kind == ValueKind::enumeration) {
        const double index = number_of(type, raw);
        const bool known = index >= 0 && index < static_cast<double>(from.choices.size());
        const auto choice =
            known ? std::ranges::find(to.field->choices, from.choices[static_cast<std::size_t>(index)])
                  : to.field->choices.end();
        if (choice == to.field->choices.end()) {
            leave_out(place);
        } else {
            set_number(*to.type, to.value, static_cast<double>(choice - to.field->choices.begin()));
        }
        return true;
    }
    const double number = as_number ? number_of(type, raw) : 0;
    const bool alike = type.kind == to.type->kind && type.size == to.type->size &&
                       type.is_signed == (type.kind == ValueKind::integer && to.type->is_signed);
    const bool in_range = !as_number || (number >= to.field->lower && number <= to.field->upper);
    if ((alike && in_range) || !as_number) {
        std::memcpy(to.value, raw.data(), to.type->size);  // bit for bit
    } else if (std::isnan(number)) {
        leave_out(place);
    } else {
        set_number(*to.type, to.value, fitted(*to.field, *to.type, number));
    }
    return true;
}

bool StoredReader::read_text(Bytes& bytes, Target to, const std::string& place) {
    std::uint64_t size = 0;
    if (!take_count(bytes, size)) {
        return false;
    }
    if (to = of_kind(ValueKind::text, to, place); to.type != nullptr) {
        static_cast<std::string*>(to.value)->assign(reinterpret_cast<const char*>(bytes.data()), size);
    }
    bytes = bytes.subspan(size);
    return true;
}

bool StoredReader::read_numbers(const StoredField& from, const StoredType& type, Bytes& bytes, Target to,
                                const std::string& place) {
    to = of_kind(ValueKind::numbers, to, place);
    if (to.type != nullptr && to.type->numbers != type.numbers) {
        leave_out(place);
        to.type = nullptr;
    }
    for (std::size_t i = 0; i < type.numbers; ++i) {
        Target element{to.field, nullptr, nullptr};
        if (to.type != nullptr) {
            element = {to.field, to.type->element, at(to.value, i * to.type->element->size)};
        }
        if (!read_scalar(from, type.element[0], bytes, element, place)) {
            return false;
        }
    }
    return true;
}

bool StoredReader::read_list(const StoredField& from, const StoredType& type, Bytes& bytes, Target to,
                             const std::string& place) {
    std::uint64_t count = 0;
    if (!take_count(bytes, count) || (type.optional && count > 1)) {
        return false;
    }
    to = of_kind(ValueKind::list, to, place);
    if (to.type != nullptr &&
        (to.type->optional != type.optional || (to.type->fixed && to.type->count(to.value) != count))) {
        leave_out(place);
        to.type = nullptr;
    }
    if (to.type != nullptr) {
        to.type->resize(to.value, 0);
        to.type->resize(to.value, count);
    }
    for (std::uint64_t i = 0; i < count; ++i) {
        Target element{to.field, nullptr, nullptr};
        if (to.type != nullptr) {
            element = {to.field, to.type->element, at(to.type->data(to.value), i * to.type->element->size)};
        }
        if (!read_any(from, type.element[0], bytes, element, place)) {
            return false;
        }
    }
    return true;
}

bool StoredReader::read_structure(const StoredType& type, Bytes& bytes, Target to, const std::string& place) {
    for (const StoredField& field : type.fields) {
        Target member{nullptr, nullptr, nullptr};
        const std::string where = place + "." + field.name;
        if (to.type != nullptr) {
            const auto found = std::ranges::find(to.type->fields, field.name, &Field::name);
            if (found != to.type->fields.end()) {
                member = {&*found, found->type, at(to.value, found->offset)};
            } else if (field.type.kind != ValueKind::opaque) {
                leave_out(where);
            }
        }
        if (!read(field, bytes, member, where)) {
            return false;
        }
    }
    return true;
}

}  // namespace lanthorn::ecs::detail
