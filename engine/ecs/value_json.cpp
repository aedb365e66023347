#include "engine/ecs/value_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "engine/ecs/number_text.h"
#include "lanthorn/core/value_info.h"

namespace lanthorn::ecs::detail {
namespace {

constexpr double kExactIntegers = 9007199254740992.0;  // 2^53

[[noreturn]] void refuse(const std::string& place, const Field& field, const Json& found) {
    throw JsonProblem{place, "is " + quoted(found) + ", expected " + field.expectation()};
}

Json number_to_json(const ValueType& type, const void* value) {
    if (type.kind == ValueKind::integer) {
        if (type.size == sizeof(std::uint64_t)) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, value, sizeof bits);
            return type.is_signed ? Json(static_cast<std::int64_t>(bits)) : Json(bits);
        }
        return Json(static_cast<std::int64_t>(number_of(type, value)));
    }
    const double number = number_of(type, value);
    if (!std::isfinite(number)) {
        return std::isnan(number) ? "nan" : number > 0 ? "inf" : "-inf";
    }
    return type.size == sizeof(float) ? shortest(static_cast<float>(number)) : number;
}

// Both readings of "inf" and "-inf", which JSON has no number for.
double real_of(const Json& json) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (json.is_string()) {
        return json == "inf" ? kInfinity : json == "-inf" ? -kInfinity : std::nan("");
    }
    return json.is_number() ? json.get<double>() : std::nan("");
}

double lowest(const ValueType& type) {
    return type.is_signed ? -std::ldexp(1.0, static_cast<int>(8 * type.size) - 1) : 0;
}
double highest(const ValueType& type) {
    return std::ldexp(1.0, static_cast<int>(8 * type.size) - (type.is_signed ? 1 : 0)) - 1;
}

const Field* find_field(const ValueType& type, std::string_view key) {
    for (const Field& field : type.fields) {
        if (field.flat) {
            if (const Field* within = find_field(*field.type, key)) {
                return within;
            }
        } else if (field.name == key && !field.transient) {
            return &field;
        }
    }
    return nullptr;
}

// The flat structure around `field`, from `value` on.
void* place_of(const ValueType& type, void* value, const Field* field) {
    for (const Field& own : type.fields) {
        if (&own == field) {
            return at(value, own.offset);
        }
        if (own.flat) {
            if (void* within = place_of(*own.type, at(value, own.offset), field)) {
                return within;
            }
        }
    }
    return nullptr;
}

void nearest_field(const ValueType& type, std::string_view key, std::string& nearest) {
    for (const Field& field : type.fields) {
        if (field.flat) {
            nearest_field(*field.type, key, nearest);
        } else if (nearest.empty() || edit_distance(key, field.name) < edit_distance(key, nearest)) {
            nearest = field.name;
        }
    }
}

}  // namespace

std::string quoted(const Json& found) {
    constexpr std::size_t kMost = 60;
    std::string text = found.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() > kMost ? text.substr(0, kMost) + "..." : text;
}

Json value_to_json(const Field& field, const ValueType& type, const void* value, const EntityNames& names,
                   Fields fields) {
    switch (type.kind) {
        case ValueKind::boolean:
            return *static_cast<const bool*>(value);
        case ValueKind::integer:
        case ValueKind::real:
            return number_to_json(type, value);
        case ValueKind::enumeration: {
            const auto index = static_cast<std::size_t>(number_of(type, value));
            return index < field.choices.size() ? Json(field.choices[index]) : Json(index);
        }
        case ValueKind::text:
            return *static_cast<const std::string*>(value);
        case ValueKind::entity: {
            const Entity e = *static_cast<const Entity*>(value);
            if (!e) {
                return nullptr;
            }
            return names.name ? names.name(e) : to_string(e);
        }
        case ValueKind::numbers:
        case ValueKind::list: {
            const bool vector = type.kind == ValueKind::numbers;
            const std::size_t count = vector ? type.numbers : type.count(value);
            const void* first = vector ? value : count > 0 ? type.data(const_cast<void*>(value)) : nullptr;
            if (type.optional) {
                return count == 0 ? Json(nullptr) : value_to_json(field, *type.element, first, names, fields);
            }
            Json array = Json::array();
            for (std::size_t i = 0; i < count; ++i) {
                array.push_back(
                    value_to_json(field, *type.element, at(first, i * type.element->size), names, fields));
            }
            return array;
        }
        case ValueKind::structure:
            return structure_to_json(type, value, names, fields);
        case ValueKind::opaque:
            break;
    }
    return nullptr;
}

Json structure_to_json(const ValueType& type, const void* value, const EntityNames& names, Fields fields) {
    Json object = Json::object();
    for (const Field& field : type.fields) {
        if (field.type->kind == ValueKind::opaque || !is_among(field, fields)) {
            continue;
        }
        Json json = value_to_json(field, *field.type, at(value, field.offset), names, fields);
        if (field.flat) {
            object.update(json);
        } else {
            object[field.name] = std::move(json);
        }
    }
    return object;
}

void ValueReader::structure(const ValueType& type, void* value, const Json& json, const std::string& place) {
    if (!json.is_object()) {
        throw JsonProblem{place, "is " + quoted(json) + ", expected an object"};
    }
    for (const auto& [key, found] : json.items()) {
        const std::string where = fmt::format("{}.{}", place, key);
        if (const Field* known = find_field(type, key)) {
            read(*known, *known->type, place_of(type, value, known), found, where);
            continue;
        }
        std::string nearest;
        nearest_field(type, key, nearest);
        unknown_.push_back({where, nearest.empty() ? "is not known, there are no fields"
                                                   : "is not known, did you mean '" + nearest + "'?"});
    }
}

void ValueReader::read_number(const Field& field, const ValueType& type, void* value, const Json& json,
                              const std::string& place) {
    if (type.kind == ValueKind::real) {
        const double x = real_of(json);
        const double kept = type.size == sizeof(float) ? static_cast<double>(static_cast<float>(x)) : x;
        if (!field.in_range(x) || (std::isfinite(x) && !std::isfinite(kept))) {
            refuse(place, field, json);
        }
        return set_number(type, value, x);
    }
    if (json.is_number_integer() && type.size == sizeof(std::uint64_t)) {
        const bool negative = !json.is_number_unsigned() && json.get<std::int64_t>() < 0;
        const bool large =
            json.is_number_unsigned() &&
            json.get<std::uint64_t>() > std::uint64_t{std::numeric_limits<std::int64_t>::max()};
        if ((negative && !type.is_signed) || (large && type.is_signed) ||
            !field.in_range(json.get<double>())) {
            refuse(place, field, json);
        }
        const std::uint64_t bits = json.get<std::uint64_t>();
        std::memcpy(value, &bits, sizeof bits);
        return;
    }
    const double x = json.is_number() ? json.get<double>() : std::nan("");
    const double most = std::min(highest(type), kExactIntegers);
    if (!(x >= std::max(lowest(type), -kExactIntegers) && x <= most) || x != std::floor(x) ||
        !field.in_range(x)) {
        refuse(place, field, json);
    }
    set_number(type, value, x);
}

void ValueReader::read_list(const Field& field, const ValueType& type, void* value, const Json& json,
                            const std::string& place) {
    if (type.optional) {
        type.resize(value, json.is_null() ? 0 : 1);
        if (!json.is_null()) {
            read(field, *type.element, type.data(value), json, place);
        }
        return;
    }
    if (!json.is_array() || (type.fixed && json.size() != type.count(value))) {
        refuse(place, field, json);
    }
    type.resize(value, json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
        read(field, *type.element, at(type.data(value), i * type.element->size), json[i],
             place + "[" + std::to_string(i) + "]");
    }
}

void ValueReader::read(const Field& field, const ValueType& type, void* value, const Json& json,
                       const std::string& place) {
    switch (type.kind) {
        case ValueKind::boolean:
            if (!json.is_boolean()) {
                refuse(place, field, json);
            }
            *static_cast<bool*>(value) = json.get<bool>();
            return;
        case ValueKind::integer:
        case ValueKind::real:
            return read_number(field, type, value, json, place);
        case ValueKind::enumeration: {
            const auto found = json.is_string()
                                   ? std::ranges::find(field.choices, json.get_ref<const std::string&>())
                                   : field.choices.end();
            if (found == field.choices.end()) {
                refuse(place, field, json);
            }
            return set_number(type, value, static_cast<double>(found - field.choices.begin()));
        }
        case ValueKind::text:
            if (!json.is_string()) {
                refuse(place, field, json);
            }
            *static_cast<std::string*>(value) = json.get<std::string>();
            return;
        case ValueKind::numbers:
            if (!json.is_array() || json.size() != type.numbers) {
                refuse(place, field, json);
            }
            for (std::size_t i = 0; i < type.numbers; ++i) {
                // A complaint shows the whole, not the number alone.
                if (!json[i].is_number() && !json[i].is_string()) {
                    refuse(place, field, json);
                }
                try {
                    read_number(field, *type.element, at(value, i * type.element->size), json[i], place);
                } catch (const JsonProblem&) {
                    refuse(place, field, json);
                }
            }
            return;
        case ValueKind::entity: {
            const bool named = json.is_string() && names_.find;
            const Entity e = named ? names_.find(json.get_ref<const std::string&>()) : kNullEntity;
            if (!e && !json.is_null()) {
                refuse(place, field, json);
            }
            *static_cast<Entity*>(value) = e;
            return;
        }
        case ValueKind::list:
            return read_list(field, type, value, json, place);
        case ValueKind::structure:
            return structure(type, value, json, place);
        case ValueKind::opaque:
            refuse(place, field, json);
    }
}

}  // namespace lanthorn::ecs::detail
