// Templates of Registry.
#pragma once

#include "lanthorn/ecs/registry.h"

namespace lanthorn::ecs {

template <class T>
void Registry::fill(DeclaredType& type, std::string name, std::string words, const ValueType& value) {
    static_assert(std::copy_constructible<T>, "declared types can be copied: snapshots and clones do");
    type.name = std::move(name);
    type.words = std::move(words);
    type.value = &value;
    if constexpr (std::is_default_constructible_v<T>) {
        type.initial = std::make_shared<const T>();
    }
    type.copy = [](void* raw, const void* from) { ::new (raw) T(*static_cast<const T*>(from)); };
    type.assign = [](void* to, const void* from) {
        if constexpr (std::is_copy_assignable_v<T>) {
            *static_cast<T*>(to) = *static_cast<const T*>(from);
        } else {
            T held(*static_cast<const T*>(from));
            static_cast<T*>(to)->~T();
            ::new (to) T(std::move(held));
        }
    };
    type.clone = [](const void* from) -> std::shared_ptr<void> {
        return std::make_shared<T>(*static_cast<const T*>(from));
    };
}

template <class T>
ComponentType& Registry::add_component(std::string name, std::string words, const ValueType& value) {
    const ComponentInfo& info = component_info<T>();
    if (info.id < by_id_.size() && by_id_[info.id] != nullptr) {
        throw Error("component '" + name + "': " + std::string(info.name) + " is declared already, as '" +
                    by_id_[info.id]->name + "'");
    }
    ComponentType type;
    fill<T>(type, std::move(name), std::move(words), value);
    type.info = &info;
    type.insert = [](World& world, Entity e, const void* from) {
        world.insert(e, T(*static_cast<const T*>(from)));
    };
    type.remove = [](World& world, Entity e) { world.remove<T>(e); };
    ComponentType& kept = components_.emplace_back(std::move(type));
    if (info.id >= by_id_.size()) {
        by_id_.resize(info.id + 1, nullptr);
    }
    by_id_[info.id] = &kept;
    by_name_[kept.name] = &kept;
    return kept;
}

template <class T>
ResourceType& Registry::add_resource(std::string name, std::string words, const ValueType& value) {
    ResourceType type;
    fill<T>(type, std::move(name), std::move(words), value);
    type.id = resource_id<T>();
    type.get = [](const World& world) -> const void* { return world.try_resource<T>(); };
    type.get_mut = [](World& world) -> void* { return &world.resource_mut<T>(); };
    type.insert = [](World& world, const void* from) {
        world.insert_resource(T(*static_cast<const T*>(from)));
    };
    type.remove = [](World& world) { world.remove_resource<T>(); };
    ResourceType& kept = resources_.emplace_back(std::move(type));
    by_name_[kept.name] = &kept;
    return kept;
}

template <class T, class... Ms>
ValueType& Registry::add_structure(const std::string& name, FieldDeclaration<T, Ms>... fields) {
    static_assert(std::is_default_constructible_v<T>, "defaults are those of a default-constructed one");
    if (find_value(&detail::type_tag<T>) != nullptr) {
        throw Error("'" + name + "': " + std::string(name_of<T>()) + " is declared already");
    }
    const T sample{};
    ValueType value;
    value.kind = ValueKind::structure;
    value.name = name;
    value.size = sizeof(T);
    (add_field(name, value, sample, std::move(fields)), ...);
    finish_structure(name, value, &sample);
    return keep(&detail::type_tag<T>, std::move(value));
}

template <class T, class M>
void Registry::add_field(const std::string& owner, ValueType& structure, const T& sample,
                         FieldDeclaration<T, M> declared) {
    Field field = declared.info();
    const auto* start = reinterpret_cast<const std::byte*>(&sample);
    const auto* member = reinterpret_cast<const std::byte*>(&(sample.*declared.member()));
    field.offset = static_cast<std::size_t>(member - start);
    field.type = declared.is_opaque() ? &opaque_type<M>() : &value_type<M>(owner + "." + field.name);
    field.transient = field.transient || field.type->kind == ValueKind::opaque;
    join_field(owner, structure, std::move(field));
}

template <class M>
const ValueType& Registry::opaque_type() {
    // Apart from what `value_type` knows of the same C++ type.
    struct Opaque {
        M value;
    };
    if (const ValueType* known = find_value(&detail::type_tag<Opaque>)) {
        return *known;
    }
    ValueType type;
    type.kind = ValueKind::opaque;
    type.name = "opaque";
    type.size = sizeof(M);
    type.opaque_within = true;
    if constexpr (detail::kComparable<M>) {
        type.opaque_equal = [](const void* a, const void* b) {
            return *static_cast<const M*>(a) == *static_cast<const M*>(b);
        };
    }
    return keep(&detail::type_tag<Opaque>, std::move(type));
}

template <class M>
const ValueType& Registry::value_type(const std::string& owner) {
    if (const ValueType* known = find_value(&detail::type_tag<M>)) {
        return *known;
    }
    ValueType type;
    type.size = sizeof(M);
    if constexpr (std::is_enum_v<M>) {
        type.kind = ValueKind::enumeration;
        type.name = "choice";
        type.plain = true;
    } else if constexpr (detail::Numbers<M>::value) {
        using Scalar = typename detail::Numbers<M>::Scalar;
        type.kind = ValueKind::numbers;
        type.element = &value_type<Scalar>(owner);
        type.numbers = detail::Numbers<M>::count;
        type.name = std::to_string(type.numbers) + " " + type.element->name;
        type.plain = true;
        static_assert(sizeof(M) == sizeof(Scalar) * detail::Numbers<M>::count);
    } else if constexpr (detail::IsOptional<M>::value || detail::IsVector<M>::value ||
                         detail::IsArray<M>::value) {
        using Element = typename M::value_type;
        static_assert(!(detail::IsVector<M>::value && std::is_same_v<Element, bool>),
                      "std::vector<bool> has no elements to point at: use std::vector<std::uint8_t>");
        type.kind = ValueKind::list;
        type.element = &value_type<Element>(owner);
        type.refers = type.element->refers;
        type.opaque_within = type.element->opaque_within;
        type.optional = detail::IsOptional<M>::value;
        type.fixed = detail::IsArray<M>::value;
        type.name = (type.optional ? "optional " : "list of ") + type.element->name;
        if constexpr (detail::IsOptional<M>::value) {
            type.count = [](const void* list) {
                return std::size_t{static_cast<const M*>(list)->has_value() ? 1u : 0u};
            };
            type.data = [](void* list) -> void* { return &**static_cast<M*>(list); };
            type.resize = [](void* list, std::size_t n) {
                M& value = *static_cast<M*>(list);
                if (n == 0) {
                    value.reset();
                } else if (!value) {
                    value.emplace();
                }
            };
        } else {
            type.count = [](const void* list) { return static_cast<const M*>(list)->size(); };
            type.data = [](void* list) -> void* { return static_cast<M*>(list)->data(); };
            type.resize = [](void* list, std::size_t n) {
                if constexpr (detail::IsVector<M>::value) {
                    static_cast<M*>(list)->resize(n);
                } else {
                    static_cast<void>(list);
                    static_cast<void>(n);
                }
            };
        }
    } else {
        throw_undeclared(owner, name_of<M>());
    }
    return keep(&detail::type_tag<M>, std::move(type));
}

}  // namespace lanthorn::ecs
