#include "lanthorn/ecs/world_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <memory>

#include "engine/ecs/value_json.h"
#include "engine/ecs/value_ops.h"
#include "lanthorn/ecs/component_json.h"

namespace lanthorn::ecs {
namespace {

struct Row {
    Entity entity;
    const void* value;
};

// All of one component, by entity index.
std::vector<Row> rows_of(const World& world, const ComponentType& type) {
    std::vector<Row> rows;
    for (const auto& archetype : world.archetypes()) {
        const int column = archetype->column(type.info->id);
        for (std::uint32_t row = 0; column != Archetype::kNoColumn && row < archetype->size(); ++row) {
            rows.push_back({archetype->entity(row), archetype->data(row, column)});
        }
    }
    if (!std::ranges::is_sorted(rows, {}, &Row::entity)) {
        std::ranges::sort(rows, {}, &Row::entity);
    }
    return rows;
}

void check_declared(const Registry& registry, const World& world) {
    for (const auto& archetype : world.archetypes()) {
        for (const ComponentInfo* info : archetype->components()) {
            if (archetype->size() > 0 && registry.find(info->id) == nullptr) {
                throw Error("state: " + std::string(info->name) + " of " + to_string(archetype->entity(0)) +
                            " is not declared");
            }
        }
    }
}

std::uint64_t hash_of(const std::string& bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

// Bytes of a part, added to without filling what is new first, as std::string would.
class PartBytes {
  public:
    void clear() { size_ = 0; }
    // Room for so many more; to be written by the caller.
    char* add(std::size_t count) {
        if (size_ + count > capacity_) {
            grow(size_ + count);
        }
        char* const place = bytes_.get() + size_;
        size_ += count;
        return place;
    }
    std::uint64_t hash() const { return XXH3_64bits(bytes_.get(), size_); }

  private:
    void grow(std::size_t least) {
        capacity_ = std::max<std::size_t>(2 * least, 1024);
        auto larger = std::make_unique_for_overwrite<char[]>(capacity_);
        std::copy_n(bytes_.get(), size_, larger.get());
        bytes_ = std::move(larger);
    }
    std::unique_ptr<char[]> bytes_ = std::make_unique_for_overwrite<char[]>(0);
    std::size_t size_ = 0, capacity_ = 0;
};

// A column of a table that is state: which part it belongs to.
struct StateColumn {
    std::size_t part;
    int column;
    const ValueType* type;
    // Of values that are plain runs: their bytes together; else kNotPlain.
    std::size_t plain;

    static constexpr std::size_t kNotPlain = ~std::size_t{0};
    static std::size_t plain_bytes(const ValueType& type) {
        std::size_t bytes = 0;
        for (const ValueType::Step& step : type.state_steps) {
            if (step.type != nullptr) {
                return kNotPlain;
            }
            bytes += step.size;
        }
        return type.kind == ValueKind::structure ? bytes : kNotPlain;
    }
};

// As append_bytes() adds it.
void add_value(const StateColumn& column, const void* value, PartBytes& to) {
    if (column.plain != StateColumn::kNotPlain) {
        char* place = to.add(column.plain);
        for (const ValueType::Step& step : column.type->state_steps) {
            std::memcpy(place, at(value, step.offset), step.size);
            place += step.size;
        }
        return;
    }
    thread_local std::string bytes;
    bytes.clear();
    append_bytes(*column.type, value, Fields::state, bytes);
    std::memcpy(to.add(bytes.size()), bytes.data(), bytes.size());
}

// All entities, to parts[0], and the components of `types`, each to the part of its place behind that: entity
// and value, in the order of entities' indices.
void append_entities(const World& world, const std::vector<const ComponentType*>& types,
                     std::vector<PartBytes>& parts) {
    struct Place {
        const Archetype* archetype = nullptr;  // null: not alive
        std::uint32_t row = 0;
        const std::vector<StateColumn>* columns = nullptr;
    };
    std::vector<Place> places;  // by entity index
    std::deque<std::vector<StateColumn>> all_columns;
    for (const auto& archetype : world.archetypes()) {
        if (archetype->size() == 0) {
            continue;
        }
        std::vector<StateColumn>& columns = all_columns.emplace_back();
        for (std::size_t i = 0; i < types.size(); ++i) {
            const int column = archetype->column(types[i]->info->id);
            if (column != Archetype::kNoColumn) {
                const ValueType& value = *types[i]->value;
                columns.push_back({1 + i, column, &value, StateColumn::plain_bytes(value)});
            }
        }
        for (std::uint32_t row = 0; row < archetype->size(); ++row) {
            const std::uint32_t index = archetype->entity(row).index;
            if (index >= places.size()) {
                places.resize(std::max<std::size_t>(index + 1, 2 * places.size()));
            }
            places[index] = {archetype.get(), row, &columns};
        }
    }
    for (const Place& place : places) {
        if (place.archetype == nullptr) {
            continue;
        }
        const std::uint64_t bits = place.archetype->entity(place.row).bits();
        std::memcpy(parts[0].add(sizeof bits), &bits, sizeof bits);
        for (const StateColumn& column : *place.columns) {
            PartBytes& part = parts[column.part];
            std::memcpy(part.add(sizeof bits), &bits, sizeof bits);
            add_value(column, place.archetype->data(place.row, column.column), part);
        }
    }
}

// What append_bytes() makes of a value, as text.
void append_schema(const ValueType& type, const std::vector<std::string>& choices, std::string& text) {
    text += std::to_string(static_cast<int>(type.kind)) + (type.is_signed ? "s" : "u");
    switch (type.kind) {
        case ValueKind::numbers:
            text += std::to_string(type.numbers);
            append_schema(*type.element, choices, text);
            break;
        case ValueKind::list:
            append_schema(*type.element, choices, text);
            break;
        case ValueKind::structure:
            for (const Field& field : type.fields) {
                if (!field.transient) {
                    text += field.name + ':';
                    append_schema(*field.type, field.choices, text);
                    text += ';';
                }
            }
            break;
        case ValueKind::enumeration:
            for (const std::string& choice : choices) {
                text += choice + ',';
            }
            [[fallthrough]];
        default:
            text += std::to_string(type.kind == ValueKind::text ? 0 : type.size);
    }
    text += '.';
}

template <class Declared>
void append_schemas(const std::deque<Declared>& all, std::vector<std::uint64_t>& schemas) {
    for (const Declared& type : all) {
        if (!type.transient) {
            std::string text = type.name + '=';
            append_schema(*type.value, {}, text);
            schemas.push_back(hash_of(text));
        }
    }
}

// The fields of one value that differ, in one line each.
void compare(const ValueType& type, const void* found, const void* expected, const std::string& where,
             std::vector<std::string>& lines) {
    for (const Field& field : type.fields) {
        const void* a = at(found, field.offset);
        const void* b = at(expected, field.offset);
        if (!field.transient && !equal(*field.type, a, b, Fields::state)) {
            lines.push_back(where + ": " + field.name + " is " +
                            detail::quoted(detail::value_to_json(field, *field.type, a, {})) + ", expected " +
                            detail::quoted(detail::value_to_json(field, *field.type, b, {})));
        }
    }
}

}  // namespace

std::vector<std::string> state_parts(const Registry& registry) {
    std::vector<std::string> names = {"entities"};
    for (const ComponentType& type : registry.components()) {
        if (!type.transient) {
            names.push_back(type.name);
        }
    }
    for (const ResourceType& type : registry.resources()) {
        if (!type.transient) {
            names.push_back(type.name);
        }
    }
    return names;
}

std::vector<std::uint64_t> state_schemas(const Registry& registry) {
    std::vector<std::uint64_t> schemas = {hash_of("entities")};
    append_schemas(registry.components(), schemas);
    append_schemas(registry.resources(), schemas);
    return schemas;
}

std::vector<std::uint64_t> state_hashes(const Registry& registry, const World& world) {
    check_declared(registry, world);
    // One pass over the entities in the order of their indices, into the bytes of every part at once.
    thread_local std::vector<PartBytes> parts;
    parts.resize(std::max(parts.size(), 1 + registry.components().size()));
    std::size_t count = 1;
    std::vector<const ComponentType*> types;
    for (const ComponentType& type : registry.components()) {
        if (!type.transient) {
            types.push_back(&type);
            ++count;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        parts[i].clear();
    }
    append_entities(world, types, parts);
    std::vector<std::uint64_t> hashes;
    hashes.reserve(count + registry.resources().size());
    for (std::size_t i = 0; i < count; ++i) {
        hashes.push_back(parts[i].hash());
    }
    std::string bytes;
    for (const ResourceType& type : registry.resources()) {
        if (!type.transient) {
            bytes.clear();
            const void* value = type.get(world);
            bytes += value != nullptr ? '\1' : '\0';
            if (value != nullptr) {
                append_bytes(*type.value, value, Fields::state, bytes);
            }
            hashes.push_back(hash_of(bytes));
        }
    }
    return hashes;
}

std::vector<std::string> state_differences(const Registry& registry, const World& found,
                                           const World& expected, std::size_t most) {
    std::vector<std::string> lines;
    for (const ComponentType& type : registry.components()) {
        if (type.transient || lines.size() >= most) {
            continue;
        }
        const std::vector<Row> a = rows_of(found, type);
        const std::vector<Row> b = rows_of(expected, type);
        for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
            const bool more = j == b.size() || (i < a.size() && a[i].entity < b[j].entity);
            const bool less = !more && (i == a.size() || b[j].entity < a[i].entity);
            const Entity e = less ? b[j].entity : a[i].entity;
            const std::string where = type.name + " of " + to_string(e);
            if (more || less) {
                lines.push_back(where + (more ? ": is there, expected none" : ": is missing"));
            } else {
                compare(*type.value, a[i].value, b[j].value, where, lines);
            }
            i += less ? 0 : 1;
            j += more ? 0 : 1;
        }
    }
    for (const ResourceType& type : registry.resources()) {
        const void* a = type.get(found);
        const void* b = type.get(expected);
        if (!type.transient && a != nullptr && b != nullptr) {
            compare(*type.value, a, b, type.name, lines);
        } else if (!type.transient && a != b) {
            lines.push_back(type.name + (a != nullptr ? ": is there, expected none" : ": is missing"));
        }
    }
    lines.resize(std::min(lines.size(), most));
    return lines;
}

}  // namespace lanthorn::ecs
