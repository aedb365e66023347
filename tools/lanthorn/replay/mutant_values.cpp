#include "tools/lanthorn/replay/mutant_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace lanthorn::tools {

namespace {

using ecs::ValueKind;

struct Row {
    ecs::Entity entity;
    const void* value;
};

std::vector<Row> rows_of(const ecs::World& world, const ecs::ComponentType& type) {
    std::vector<Row> rows;
    for (const auto& archetype : world.archetypes()) {
        const int column = archetype->column(type.info->id);
        for (std::uint32_t row = 0; column >= 0 && row < archetype->size(); ++row) {
            rows.push_back({archetype->entity(row), archetype->data(row, column)});
        }
    }
    std::ranges::sort(rows, {}, &Row::entity);
    return rows;
}

// A scalar somewhere within a value.
struct Leaf {
    std::string name;
    const ecs::ValueType* type;
    const ecs::Field* field;
    std::byte* place;
};

void collect(const ecs::Field& field, const ecs::ValueType& type, std::byte* place, const std::string& name,
             std::vector<Leaf>& leaves) {
    switch (type.kind) {
        case ValueKind::structure:
            for (const ecs::Field& inner : type.fields) {
                if (!inner.transient) {
                    collect(inner, *inner.type, place + inner.offset,
                            name.empty() ? inner.name : name + "." + inner.name, leaves);
                }
            }
            break;
        case ValueKind::numbers:
            for (std::size_t i = 0; i < type.numbers; ++i) {
                leaves.push_back(
                    {fmt::format("{}[{}]", name, i), type.element, &field, place + i * type.element->size});
            }
            break;
        case ValueKind::list:
            for (std::size_t i = 0; i < type.count(place); ++i) {
                collect(field, *type.element,
                        static_cast<std::byte*>(type.data(place)) + i * type.element->size,
                        fmt::format("{}[{}]", name, i), leaves);
            }
            break;
        case ValueKind::entity:
        case ValueKind::opaque:
            break;
        default:
            leaves.push_back({name, &type, &field, place});
    }
}

std::vector<Leaf> leaves_of(const ecs::ValueType& type, void* value) {
    std::vector<Leaf> leaves;
    ecs::Field whole;
    collect(whole, type, static_cast<std::byte*>(value), "", leaves);
    std::erase_if(leaves, [](const Leaf& leaf) {
        return leaf.type->kind == ValueKind::enumeration && leaf.field->choices.size() < 2;
    });
    return leaves;
}

void alter(const Leaf& leaf) {
    switch (leaf.type->kind) {
        case ValueKind::boolean:
            set_number(*leaf.type, leaf.place, number_of(*leaf.type, leaf.place) == 0 ? 1 : 0);
            break;
        case ValueKind::enumeration: {
            const auto next = static_cast<std::size_t>(number_of(*leaf.type, leaf.place)) + 1;
            set_number(*leaf.type, leaf.place, static_cast<double>(next % leaf.field->choices.size()));
            break;
        }
        case ValueKind::text:
            *reinterpret_cast<std::string*>(leaf.place) += '?';
            break;
        default:
            *leaf.place ^= std::byte{1};  // little-endian: the last bit
    }
}

}  // namespace

bool has_part(const ecs::Registry& registry, const std::string& part) {
    const auto is = [&](const ecs::DeclaredType& type) { return type.name == part && !type.transient; };
    return std::ranges::any_of(registry.components(), is) || std::ranges::any_of(registry.resources(), is);
}

std::string flip_bit(const ecs::Registry& registry, ecs::World& world, const std::string& part,
                     std::uint64_t number) {
    if (const ecs::ComponentType* type = registry.find(part)) {
        const std::vector<Row> rows = rows_of(world, *type);
        if (rows.empty()) {
            return "";
        }
        const Row row = rows[number % rows.size()];
        const std::shared_ptr<void> value = type->clone(row.value);
        const std::vector<Leaf> leaves = leaves_of(*type->value, value.get());
        if (leaves.empty()) {
            type->remove(world, row.entity);
            return fmt::format("{} of {} taken away", part, to_string(row.entity));
        }
        const Leaf& leaf = leaves[number / 7 % leaves.size()];
        alter(leaf);
        type->insert(world, row.entity, value.get());
        return fmt::format("{} of {} of {}", leaf.name, part, to_string(row.entity));
    }
    for (const ecs::ResourceType& type : registry.resources()) {
        if (void* value = type.name == part && !type.transient ? type.get_mut(world) : nullptr) {
            const std::vector<Leaf> leaves = leaves_of(*type.value, value);
            if (!leaves.empty()) {
                alter(leaves[number % leaves.size()]);
                return fmt::format("{} of {}", leaves[number % leaves.size()].name, part);
            }
        }
    }
    return "";
}

std::string swap_two(const ecs::Registry& registry, ecs::World& world, const std::string& part,
                     std::uint64_t number) {
    const ecs::ComponentType* type = registry.find(part);
    const std::vector<Row> rows = type != nullptr ? rows_of(world, *type) : std::vector<Row>();
    // From a row that `number` chooses on: the first two neighbours that are not alike.
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        const Row a = rows[(number + i) % rows.size()], b = rows[(number + i + 1) % rows.size()];
        const std::shared_ptr<void> of_a = type->clone(a.value), of_b = type->clone(b.value);
        const std::vector<Leaf> la = leaves_of(*type->value, of_a.get()),
                                lb = leaves_of(*type->value, of_b.get());
        const bool alike = std::ranges::equal(la, lb, [](const Leaf& x, const Leaf& y) {
            return x.type == y.type &&
                   (x.type->kind == ValueKind::text ? *reinterpret_cast<const std::string*>(x.place) ==
                                                          *reinterpret_cast<const std::string*>(y.place)
                                                    : std::memcmp(x.place, y.place, x.type->size) == 0);
        });
        if (!alike) {
            type->insert(world, a.entity, of_b.get());
            type->insert(world, b.entity, of_a.get());
            return fmt::format("{} of {} and {}", part, to_string(a.entity), to_string(b.entity));
        }
    }
    return "";
}

}  // namespace lanthorn::tools
