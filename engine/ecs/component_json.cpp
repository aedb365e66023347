#include "lanthorn/ecs/component_json.h"

#include <algorithm>

#include "engine/core/json.h"
#include "engine/ecs/value_json.h"
#include "engine/ecs/value_ops.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/value_info.h"

namespace lanthorn::ecs {
namespace {

using detail::Json;

// A name so near to a declared one that it is taken for a slip of the pen.
const ComponentType* nearly(const Registry& registry, std::string_view name) {
    for (const ComponentType& type : registry.components()) {
        const std::size_t allowed = std::clamp<std::size_t>(type.name.size() / 3, 1, 2);
        if (type.in_extras && edit_distance(name, type.name) <= allowed) {
            return &type;
        }
    }
    return nullptr;
}

// A component as `json` has it, fields left out as in `start`. Throws a JsonProblem.
std::shared_ptr<void> read_component(const ComponentType& type, const void* start, const Json& json,
                                     const EntityNames& names, std::vector<JsonProblem>& unknown) {
    std::shared_ptr<void> value = type.clone(start);
    detail::ValueReader reader(names, unknown);
    if (!json.is_object() && !type.brief_field.empty()) {
        reader.structure(*type.value, value.get(), Json{{type.brief_field, json}}, type.name);
    } else {
        reader.structure(*type.value, value.get(), json, type.name);
    }
    if (type.check) {
        if (const std::string wrong = type.check(value.get()); !wrong.empty()) {
            throw JsonProblem{type.name + "." + wrong.substr(0, wrong.find(' ')),
                              wrong.substr(std::min(wrong.find(' ') + 1, wrong.size()))};
        }
    }
    return value;
}

// Discarded if it is no JSON.
Json parse(std::string_view text) {
    return json_if_valid(text).value_or(Json(Json::value_t::discarded));
}

// The component and the field's path below it.
std::pair<std::string_view, std::string_view> split(std::string_view path) {
    const std::size_t dot = path.find('.');
    return dot == std::string_view::npos ? std::pair(path, std::string_view())
                                         : std::pair(path.substr(0, dot), path.substr(dot + 1));
}

struct Found {
    const Field* field = nullptr;
    std::size_t offset = 0;
};

// Null `field` if there is none; the fields of flat structures are found like their neighbours.
Found find_field(const ValueType& type, std::string_view path) {
    const auto [first, rest] = split(path);
    for (const Field& field : type.fields) {
        const bool here = field.name == first;
        if (here && rest.empty()) {
            return {&field, field.offset};
        }
        if (field.type->kind == ValueKind::structure && (here || field.flat)) {
            Found found = find_field(*field.type, here ? rest : path);
            if (found.field != nullptr) {
                found.offset += field.offset;
                return found;
            }
        }
    }
    return {};
}

Found find_field_or_throw(const ValueType& type, std::string_view path, std::string_view whole) {
    const Found found = find_field(type, path);
    if (found.field == nullptr) {
        throw InputError("'" + std::string(whole) + "': there is no field '" + std::string(path) + "'");
    }
    return found;
}

void check_has(const void* component, Entity e, const ComponentType& type) {
    if (component == nullptr) {
        throw InputError(to_string(e) + " has no component '" + type.name + "'");
    }
}

// What of `now` differs from `read`, put into `object`.
void patch(Json& object, const Json& now, const Json& read) {
    for (const auto& [key, value] : now.items()) {
        if (!read.contains(key) || read[key] != value) {
            object[key] = value;
        }
    }
}

}  // namespace

const void* get(const World& world, Entity e, const ComponentType& type) {
    const World::Row row = world.row_of(e);
    if (!row) {
        World::throw_dead("get", e);
    }
    const int column = row.archetype->column(type.info->id);
    return column == Archetype::kNoColumn ? nullptr : row.archetype->data(row.row, column);
}

void* get_mut(World& world, Entity e, const ComponentType& type) {
    const World::Row row = world.row_of(e);
    if (!row) {
        World::throw_dead("get", e);
    }
    const int column = row.archetype->column(type.info->id);
    if (column == Archetype::kNoColumn) {
        return nullptr;
    }
    row.archetype->mark_changed(row.row, column, world.row_tick(world.now()));
    return row.archetype->data(row.row, column);
}

std::string to_json(const ComponentType& type, const void* component, const EntityNames& names) {
    return detail::structure_to_json(*type.value, component, names).dump();
}

std::string list_markdown(const Registry& registry) {
    std::string out = "| component | field | value | default | what |\n|---|---|---|---|---|\n";
    const std::function<void(const ValueType&, const void*)> add_fields = [&](const ValueType& type,
                                                                              const void* initial) {
        for (const Field& field : type.fields) {
            const void* value = at(initial, field.offset);
            if (field.flat) {
                add_fields(*field.type, value);
            } else if (is_among(field, Fields::author) && field.type->kind != ValueKind::opaque) {
                out += "| | `" + field.name + "` | " + table_cell(field.expectation()) + " | `" +
                       table_cell(detail::value_to_json(field, *field.type, value, {}).dump()) + "` | " +
                       table_cell(field.words) + " |\n";
            }
        }
    };
    for (const ComponentType& type : registry.components()) {
        if (type.in_extras && !type.opaque && !type.runtime) {
            out += "| **`" + type.name + "`** | | | | " + table_cell(type.words) + " |\n";
            add_fields(*type.value, type.initial.get());
        }
    }
    return out;
}

void from_json(const ComponentType& type, void* component, std::string_view json, const EntityNames& names) {
    const Json parsed = parse(json);
    if (parsed.is_discarded()) {
        throw InputError(type.name + ": is not JSON, expected an object");
    }
    std::vector<JsonProblem> unknown;
    std::shared_ptr<void> value;
    try {
        value = read_component(type, component, parsed, names, unknown);
    } catch (const JsonProblem& problem) {
        throw InputError(problem.line());
    }
    if (!unknown.empty()) {
        throw InputError(unknown.front().line());
    }
    type.assign(component, value.get());
}

std::string get_json(const Registry& registry, const World& world, Entity e, std::string_view path,
                     const EntityNames& names) {
    const auto [name, rest] = split(path);
    const ComponentType& type = registry.find_or_throw(name);
    const void* component = get(world, e, type);
    check_has(component, e, type);
    if (rest.empty()) {
        return to_json(type, component, names);
    }
    const Found found = find_field_or_throw(*type.value, rest, path);
    return detail::value_to_json(*found.field, *found.field->type, at(component, found.offset), names).dump();
}

void set_json(const Registry& registry, World& world, Entity e, std::string_view path, std::string_view json,
              const EntityNames& names) {
    const auto [name, rest] = split(path);
    const ComponentType& type = registry.find_or_throw(name);
    const void* present = get(world, e, type);
    check_has(present, e, type);
    const std::shared_ptr<void> value = type.clone(present);
    if (rest.empty()) {
        from_json(type, value.get(), json, names);
    } else {
        const Found found = find_field_or_throw(*type.value, rest, path);
        const Json parsed = parse(json);
        std::vector<JsonProblem> unknown;
        try {
            if (parsed.is_discarded()) {
                throw JsonProblem{std::string(path), "is not JSON, expected " + found.field->expectation()};
            }
            detail::ValueReader(names, unknown)
                .field(*found.field, at(value.get(), found.offset), parsed, std::string(path));
            if (!unknown.empty()) {
                throw unknown.front();
            }
        } catch (const JsonProblem& problem) {
            throw InputError(problem.line());
        }
        if (const std::string wrong = type.check ? type.check(value.get()) : ""; !wrong.empty()) {
            throw InputError(type.name + "." + wrong);
        }
    }
    type.insert(world, e, value.get());
}

ExtrasReading read_extras(const Registry& registry, std::string_view extras, const EntityNames& names) {
    ExtrasReading reading;
    const Json parsed = parse(extras);
    if (parsed.is_discarded()) {
        reading.skipped.push_back({"extras", "are not JSON, expected an object"});
        return reading;
    }
    if (!parsed.is_object()) {
        return reading;  // another program's
    }
    for (const ComponentType& type : registry.components()) {
        const auto found = type.in_extras ? parsed.find(type.name) : parsed.end();
        if (found == parsed.end()) {
            continue;
        }
        try {
            reading.values.push_back(
                read_component(type, type.initial.get(), *found, names, reading.ignored));
            reading.types.push_back(&type);
        } catch (const JsonProblem& problem) {
            reading.skipped.push_back(problem);
        }
    }
    for (const auto& [key, value] : parsed.items()) {
        const ComponentType* exact = registry.find(key);
        const ComponentType* near = exact != nullptr || !value.is_object() ? nullptr : nearly(registry, key);
        if (near != nullptr) {
            reading.ignored.push_back({key, "is no component, did you mean '" + near->name + "'?"});
        }
    }
    return reading;
}

std::string write_extras(const Registry& registry, const World& world, Entity e, const std::string& extras,
                         const EntityNames& names) {
    Json object = extras.empty() ? Json::object() : parse(extras);
    if (!object.is_object()) {
        return extras;
    }
    const ExtrasReading before = read_extras(registry, extras.empty() ? "{}" : extras, names);
    bool altered = false;
    for (const ComponentType& type : registry.components()) {
        if (!type.in_extras || type.transient || type.runtime) {
            continue;
        }
        const void* now = get(world, e, type);
        const auto known = std::ranges::find(before.types, &type);
        const void* read = known != before.types.end()
                               ? before.values[static_cast<std::size_t>(known - before.types.begin())].get()
                               : nullptr;
        if (now == nullptr) {
            // What could not be read was never made a component, and stays.
            altered = read != nullptr || altered;
            if (read != nullptr) {
                object.erase(type.name);
            }
            continue;
        }
        if (read != nullptr && equal(*type.value, read, now, Fields::author)) {
            continue;
        }
        altered = true;
        Json& entry = object[type.name];
        if (!entry.is_object()) {
            entry = Json::object();
            read = nullptr;  // written briefly before, or damaged
        }
        const void* base = read != nullptr ? read : type.initial.get();
        patch(entry, detail::structure_to_json(*type.value, now, names, Fields::author),
              detail::structure_to_json(*type.value, base, names, Fields::author));
    }
    return altered ? object.dump() : extras;
}

}  // namespace lanthorn::ecs
