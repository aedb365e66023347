#include "lanthorn/ecs/registry.h"

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>

#include "engine/ecs/number_text.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/value_info.h"

namespace lanthorn::ecs {
namespace {

template <class T>
ValueType scalar(ValueKind kind, std::string name) {
    ValueType type;
    type.kind = kind;
    type.name = std::move(name);
    type.size = sizeof(T);
    type.is_signed = std::is_signed_v<T>;
    type.plain = true;
    return type;
}

bool good_name(std::string_view name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    return !name.empty() && name.front() >= 'a' && name.front() <= 'z' && std::ranges::all_of(name, allowed);
}

// The leaf that a field's numbers or choices are of.
const ValueType& leaf(const ValueType& type) {
    return type.element != nullptr ? leaf(*type.element) : type;
}

// What is wrong with a field's value: "is 5, expected a number from 0 to 3"; empty: nothing.
std::string wrong_value(const Field& field, const ValueType& type, const void* value) {
    if (type.kind == ValueKind::numbers || type.kind == ValueKind::list) {
        const bool vector = type.kind == ValueKind::numbers;
        const std::size_t count = vector ? type.numbers : type.count(value);
        const void* first = vector ? value : count > 0 ? type.data(const_cast<void*>(value)) : nullptr;
        for (std::size_t i = 0; i < count; ++i) {
            if (std::string wrong = wrong_value(field, *type.element, at(first, i * type.element->size));
                !wrong.empty()) {
                return wrong;
            }
        }
    } else if (type.kind == ValueKind::real || type.kind == ValueKind::integer) {
        const double x = number_of(type, value);
        if (!field.in_range(x)) {
            return "is " + number_text(x) + ", expected " + field.expectation();
        }
    } else if (type.kind == ValueKind::enumeration) {
        const double x = number_of(type, value);
        if (x < 0 || x >= static_cast<double>(field.choices.size())) {
            return "is " + number_text(x) + ", expected " + field.expectation();
        }
    } else if (type.kind == ValueKind::structure) {
        for (const Field& within : type.fields) {
            if (std::string wrong = wrong_value(within, *within.type, at(value, within.offset));
                !wrong.empty()) {
                return field.flat ? within.name + " " + wrong : "has a " + within.name + " that " + wrong;
            }
        }
    }
    return "";
}

// The plain neighbours among the fields as one run each.
std::vector<ValueType::Step> steps(const std::vector<Field>& fields, bool state_alone) {
    std::vector<ValueType::Step> result;
    for (const Field& field : fields) {
        if (state_alone && field.transient) {
            continue;
        }
        const ValueType& type = *field.type;
        if (!type.plain) {
            result.push_back({field.offset, type.size, &type});
        } else if (!result.empty() && result.back().type == nullptr &&
                   result.back().offset + result.back().size == field.offset) {
            result.back().size += type.size;
        } else {
            result.push_back({field.offset, type.size, nullptr});
        }
    }
    return result;
}

void describe(const ValueType& type, std::string& text) {
    text += type.name + "/" + std::to_string(type.size);
    for (const Field& field : type.fields) {
        text += "{" + field.name + ":";
        describe(*field.type, text);
        for (const std::string& choice : field.choices) {
            text += "|" + choice;
        }
        text += "}";
    }
    if (type.kind == ValueKind::list) {
        describe(*type.element, text);
    }
}

}  // namespace

Registry::Registry() {
    const auto add = [this]<class T>(T*, ValueKind kind, const char* name) {
        keep(&detail::type_tag<T>, scalar<T>(kind, name));
    };
    add(static_cast<bool*>(nullptr), ValueKind::boolean, "bool");
    add(static_cast<std::int8_t*>(nullptr), ValueKind::integer, "int8");
    add(static_cast<std::int16_t*>(nullptr), ValueKind::integer, "int16");
    add(static_cast<std::int32_t*>(nullptr), ValueKind::integer, "int32");
    add(static_cast<std::int64_t*>(nullptr), ValueKind::integer, "int64");
    add(static_cast<std::uint8_t*>(nullptr), ValueKind::integer, "uint8");
    add(static_cast<std::uint16_t*>(nullptr), ValueKind::integer, "uint16");
    add(static_cast<std::uint32_t*>(nullptr), ValueKind::integer, "uint32");
    add(static_cast<std::uint64_t*>(nullptr), ValueKind::integer, "uint64");
    add(static_cast<float*>(nullptr), ValueKind::real, "float");
    add(static_cast<double*>(nullptr), ValueKind::real, "double");
    ValueType entity = scalar<std::uint64_t>(ValueKind::entity, "entity");
    entity.refers = true;
    keep(&detail::type_tag<Entity>, std::move(entity));
    ValueType text = scalar<char>(ValueKind::text, "text");
    text.size = sizeof(std::string);
    text.plain = false;
    keep(&detail::type_tag<std::string>, std::move(text));
}

std::string problem_of(const DeclaredType& type, const void* value) {
    for (const Field& field : type.value->fields) {
        const std::string wrong = wrong_value(field, *field.type, at(value, field.offset));
        if (!wrong.empty()) {
            return field.flat ? wrong : field.name + " " + wrong;
        }
    }
    return type.check ? type.check(value) : "";
}

const ComponentType* Registry::find(std::string_view name) const {
    const auto found = std::ranges::find(components_, name, &ComponentType::name);
    return found != components_.end() ? &*found : nullptr;
}

const ComponentType* Registry::find(TypeId id) const {
    return id < by_id_.size() ? by_id_[id] : nullptr;
}

const ComponentType& Registry::find_or_throw(std::string_view name) const {
    if (const ComponentType* found = find(name)) {
        return *found;
    }
    std::string line = "component '" + std::string(name) + "' is not declared";
    const ComponentType* nearest = nullptr;
    for (const ComponentType& type : components_) {
        if (nearest == nullptr || edit_distance(name, type.name) < edit_distance(name, nearest->name)) {
            nearest = &type;
        }
    }
    throw InputError(nearest != nullptr ? line + ", did you mean '" + nearest->name + "'?" : line);
}

std::uint64_t Registry::schema_hash() const {
    std::string text;
    for (const ComponentType& type : components_) {
        text += "component " + type.name + " ";
        describe(*type.value, text);
    }
    for (const ResourceType& type : resources_) {
        text += "resource " + type.name + " ";
        describe(*type.value, text);
    }
    return XXH3_64bits(text.data(), text.size());
}

const ValueType* Registry::find_value(const void* tag) const {
    const auto found = value_of_tag_.find(tag);
    return found != value_of_tag_.end() ? found->second : nullptr;
}

ValueType& Registry::keep(const void* tag, ValueType type) {
    ValueType& kept = values_.emplace_back(std::move(type));
    value_of_tag_[tag] = &kept;
    return kept;
}

void Registry::check_name(const std::string& name) const {
    if (!good_name(name)) {
        throw Error("component '" + name + "': malformed name, expected letters, digits and _");
    }
    if (by_name_.contains(name)) {
        throw Error("component '" + name + "' is declared already");
    }
}

void Registry::throw_undeclared(const std::string& owner, std::string_view type) {
    throw Error("'" + owner + "': " + std::string(type) +
                " is no type that a field can have; declare it with Registry::structure, or say .opaque()");
}

void Registry::join_field(const std::string& owner, ValueType& structure, Field field) {
    const std::string where = owner + "." + field.name;
    if (!good_name(field.name)) {
        throw Error("'" + where + "': malformed name, expected letters, digits and _");
    }
    for (const Field& other : structure.fields) {
        if (other.name == field.name) {
            throw Error("'" + where + "' is declared twice");
        }
        if (other.offset == field.offset && other.type->size > 0 && field.type->size > 0) {
            throw Error(fmt::format("'{}' and '{}.{}' are the same member", where, owner, other.name));
        }
    }
    if (leaf(*field.type).kind == ValueKind::enumeration && field.choices.empty()) {
        throw Error("'" + where + "': an enumeration needs the names of its choices");
    }
    if (field.flat && field.type->kind != ValueKind::structure) {
        throw Error("'" + where + "': only a structure can be flat");
    }
    structure.refers = structure.refers || field.type->refers;
    structure.opaque_within = structure.opaque_within || field.type->opaque_within;
    structure.fields.push_back(std::move(field));
}

void Registry::finish_structure(const std::string& owner, ValueType& structure, const void* sample) {
    for (const Field& field : structure.fields) {
        const std::string wrong = wrong_value(field, *field.type, at(sample, field.offset));
        if (!wrong.empty()) {
            throw Error(fmt::format("'{}.{}': its default {}", owner, field.name, wrong));
        }
    }
    structure.all_steps = steps(structure.fields, false);
    structure.state_steps = steps(structure.fields, true);
    const auto whole = [&](const std::vector<ValueType::Step>& s) {
        return s.size() == 1 && s[0].type == nullptr && s[0].size == structure.size;
    };
    structure.plain = whole(structure.all_steps) && whole(structure.state_steps);
}

}  // namespace lanthorn::ecs
