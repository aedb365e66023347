// What the storage must know of a component, resource or event type: an id, a readable name, how to move and
// destroy it.
#pragma once

#include <concepts>
#include <cstdint>
#include <cstring>
#include <new>
#include <string_view>
#include <type_traits>
#include <utility>

#include "lanthorn/ecs/hooks.h"

namespace lanthorn::ecs {

using TypeId = std::uint32_t;

namespace detail {

// Counts up from 0, one number a type per kind; thread-safe. Ids depend on the order of first use: never
// store them.
TypeId next_component_id();
TypeId next_resource_id();
TypeId next_event_id();
TypeId next_bundle_id();

template <class T>
constexpr std::string_view type_name() {
#if defined(__clang__)
    constexpr std::string_view text = __PRETTY_FUNCTION__;
    constexpr std::string_view start = "[T = ";
#else
    constexpr std::string_view text = __PRETTY_FUNCTION__;
    constexpr std::string_view start = "[with T = ";
#endif
    constexpr std::size_t from = text.find(start) + start.size();
    constexpr std::size_t semicolon = text.find("; std::string_view", from);
    constexpr std::size_t to = semicolon != std::string_view::npos ? semicolon : text.rfind(']');
    return text.substr(from, to - from);
}

}  // namespace detail

// The type's name with its namespaces, as error messages and graphs show it.
template <class T>
constexpr std::string_view name_of() {
    return detail::type_name<std::remove_cvref_t<T>>();
}

// Anything that can be moved into place. A move constructor that throws ends the program: storage cannot undo
// half a move.
template <class T>
concept Component = std::is_object_v<T> && !std::is_const_v<T> && !std::is_array_v<T> &&
                    std::move_constructible<T> && std::destructible<T>;

// What storage knows of a component type: one a type, for ever.
struct ComponentInfo {
    TypeId id;
    std::string_view name;
    std::size_t size;
    std::size_t align;
    bool trivial;                                     // bytes may be copied, nothing need be destroyed
    void (*relocate)(void* to, void* from) noexcept;  // move-constructs *to, destroys *from
    void (*destroy)(void* at) noexcept;
    detail::HookFunction on_add;  // the type's own hooks; null: none
    detail::HookFunction on_remove;
};

namespace detail {

template <class T>
void relocate(void* to, void* from) noexcept {
    T* source = static_cast<T*>(from);
    ::new (to) T(std::move(*source));
    source->~T();
}

template <class T>
void destroy(void* at) noexcept {
    static_cast<T*>(at)->~T();
}

}  // namespace detail

// What the storage knows of T; the same object for one T in all of the program. Thread-safe.
template <Component T>
const ComponentInfo& component_info() {
    static const ComponentInfo info{
        detail::next_component_id(),     name_of<T>(),         sizeof(T),           alignof(T),
        std::is_trivially_copyable_v<T>, &detail::relocate<T>, &detail::destroy<T>, detail::add_hook<T>(),
        detail::remove_hook<T>()};
    return info;
}

// The number of T among resource types; not the same in every run, so never to be stored. Thread-safe.
template <class T>
TypeId resource_id() {
    static const TypeId id = detail::next_resource_id();
    return id;
}

// The number of T among event types; likewise.
template <class T>
TypeId event_id() {
    static const TypeId id = detail::next_event_id();
    return id;
}

}  // namespace lanthorn::ecs
