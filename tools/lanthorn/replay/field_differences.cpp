#include "tools/lanthorn/replay/field_differences.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>

#include "engine/ecs/value_ops.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::tools {

namespace {

using ecs::Field;
using ecs::ValueKind;
using ecs::ValueType;

constexpr const char* kAxes[] = {"x", "y", "z", "w"};

// The places of two numbers in the order of all floating-point numbers, apart.
template <class Float, class Bits>
std::uint64_t ulps_between(const void* a, const void* b) {
    Bits x = 0, y = 0;
    std::memcpy(&x, a, sizeof x);
    std::memcpy(&y, b, sizeof y);
    const auto place = [](Bits bits) {
        constexpr Bits kSign = Bits{1} << (8 * sizeof(Bits) - 1);
        return (bits & kSign) != 0 ? static_cast<Bits>(~bits) : static_cast<Bits>(bits | kSign);
    };
    const Bits p = place(x), q = place(y);
    return p > q ? p - q : q - p;
}

std::string bits_text(const void* value, std::size_t size) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, value, size);
    return size == sizeof(float) ? fmt::format("{:08x}", bits) : fmt::format("{:016x}", bits);
}

class Finder {
  public:
    Finder(std::size_t most, std::vector<FieldDifference>& all) : most_(most), all_(all) {}

    bool full() const { return all_.size() >= most_; }
    // Where what is compared next belongs.
    void place(std::string part, std::string entity, ecs::Entity id = ecs::kNullEntity) {
        part_ = std::move(part);
        entity_ = std::move(entity);
        id_ = id;
    }
    void add(const std::string& field, std::string found, std::string expected, int sign = 0,
             std::uint64_t ulps = 0) {
        if (!full()) {
            all_.push_back({part_, entity_, field, std::move(found), std::move(expected), sign, ulps, id_});
        }
    }
    void compare(const ValueType& type, const Field* field, const void* found, const void* expected,
                 const std::string& path) {
        if (full() || ecs::equal(type, found, expected, ecs::Fields::state)) {
            return;
        }
        switch (type.kind) {
            case ValueKind::structure:
                compare_fields(type, found, expected, path);
                break;
            case ValueKind::numbers:
                for (std::size_t i = 0; i < type.numbers; ++i) {
                    const std::string axis = type.numbers <= 4 ? kAxes[i] : fmt::format("{}", i);
                    compare(*type.element, field, ecs::at(found, i * type.element->size),
                            ecs::at(expected, i * type.element->size), fmt::format("{}.{}", path, axis));
                }
                break;
            case ValueKind::list:
                compare_list(type, field, found, expected, path);
                break;
            case ValueKind::real:
                compare_reals(type, found, expected, path);
                break;
            default:
                add(path, text(type, field, found), text(type, field, expected), sign(type, found, expected));
        }
    }

  private:
    void compare_fields(const ValueType& type, const void* found, const void* expected,
                        const std::string& path) {
        for (const Field& field : type.fields) {
            if (!field.transient) {
                compare(*field.type, &field, ecs::at(found, field.offset), ecs::at(expected, field.offset),
                        path.empty() ? field.name : path + "." + field.name);
            }
        }
    }
    void compare_list(const ValueType& type, const Field* field, const void* found, const void* expected,
                      const std::string& path) {
        const std::size_t a = type.count(found), b = type.count(expected);
        if (a != b) {
            add(path, fmt::format("{} of them", a), fmt::format("{}", b), a < b ? -1 : 1);
            return;
        }
        const auto first = [&](const void* list) { return type.data(const_cast<void*>(list)); };
        for (std::size_t i = 0; i < a; ++i) {
            compare(*type.element, field, ecs::at(first(found), i * type.element->size),
                    ecs::at(first(expected), i * type.element->size), fmt::format("{}[{}]", path, i));
        }
    }
    void compare_reals(const ValueType& type, const void* found, const void* expected,
                       const std::string& path) {
        const bool is_float = type.size == sizeof(float);
        const double a = ecs::number_of(type, found), b = ecs::number_of(type, expected);
        const auto words = [&](double value, const void* at) {
            return fmt::format("{:.{}g} ({})", value, is_float ? 9 : 17, bits_text(at, type.size));
        };
        const std::uint64_t ulps = std::isnan(a) || std::isnan(b) ? 0
                                   : is_float ? ulps_between<float, std::uint32_t>(found, expected)
                                              : ulps_between<double, std::uint64_t>(found, expected);
        add(path, words(a, found), words(b, expected), sign(type, found, expected), ulps);
    }
    static int sign(const ValueType& type, const void* found, const void* expected) {
        if (type.kind != ValueKind::boolean && type.kind != ValueKind::integer &&
            type.kind != ValueKind::real && type.kind != ValueKind::enumeration) {
            return 0;
        }
        const double a = ecs::number_of(type, found), b = ecs::number_of(type, expected);
        return a < b ? -1 : a > b ? 1 : 0;
    }
    static std::string text(const ValueType& type, const Field* field, const void* value) {
        switch (type.kind) {
            case ValueKind::text:
                return "'" + *static_cast<const std::string*>(value) + "'";
            case ValueKind::entity:
                return ecs::to_string(*static_cast<const ecs::Entity*>(value));
            case ValueKind::boolean:
                return ecs::number_of(type, value) != 0 ? "true" : "false";
            case ValueKind::enumeration: {
                const auto number = static_cast<std::size_t>(ecs::number_of(type, value));
                return field != nullptr && number < field->choices.size() ? field->choices[number]
                                                                          : fmt::format("{}", number);
            }
            case ValueKind::integer:
                return fmt::format("{:.0f}", ecs::number_of(type, value));
            default:
                return "?";
        }
    }

    std::size_t most_;
    std::vector<FieldDifference>& all_;
    std::string part_, entity_;
    ecs::Entity id_;
};

std::set<ecs::Entity> entities_of(const ecs::World& world) {
    std::set<ecs::Entity> all;
    for (const auto& archetype : world.archetypes()) {
        for (std::uint32_t row = 0; row < archetype->size(); ++row) {
            all.insert(archetype->entity(row));
        }
    }
    return all;
}

std::string words_of(const ecs::World& world, ecs::Entity e) {
    const Name* name = world.alive(e) ? world.try_get<Name>(e) : nullptr;
    return name != nullptr && !name->value.empty() ? fmt::format("{} ({})", name->value, ecs::to_string(e))
                                                   : ecs::to_string(e);
}

}  // namespace

std::vector<FieldDifference> field_differences(const ecs::Registry& registry, const ecs::World& found,
                                               const ecs::World& expected, std::size_t most) {
    std::vector<FieldDifference> all;
    Finder finder(most, all);
    std::set<ecs::Entity> entities = entities_of(found);
    entities.merge(entities_of(expected));
    for (const ecs::Entity e : entities) {
        if (found.alive(e) != expected.alive(e)) {
            finder.place("entities", words_of(found.alive(e) ? found : expected, e), e);
            finder.add("", found.alive(e) ? "alive" : "none", found.alive(e) ? "none" : "alive");
        }
    }
    for (const ecs::ComponentType& type : registry.components()) {
        for (const ecs::Entity e : entities) {
            if (type.transient || finder.full()) {
                break;
            }
            const void* a = found.alive(e) ? ecs::get(found, e, type) : nullptr;
            const void* b = expected.alive(e) ? ecs::get(expected, e, type) : nullptr;
            if (a == nullptr && b == nullptr) {
                continue;
            }
            finder.place(type.name, words_of(a != nullptr ? found : expected, e), e);
            if (a == nullptr || b == nullptr) {
                finder.add("", a != nullptr ? "there" : "none", b != nullptr ? "there" : "none");
            } else {
                finder.compare(*type.value, nullptr, a, b, "");
            }
        }
    }
    for (const ecs::ResourceType& type : registry.resources()) {
        const void* a = type.get(found);
        const void* b = type.get(expected);
        finder.place(type.name, "");
        if (!type.transient && a != nullptr && b != nullptr) {
            finder.compare(*type.value, nullptr, a, b, "");
        } else if (!type.transient && a != b) {
            finder.add("", a != nullptr ? "there" : "none", b != nullptr ? "there" : "none");
        }
    }
    return all;
}

}  // namespace lanthorn::tools
