// Hooks: what happens whenever a component comes or goes, so that what is derived from it cannot be
// forgotten.
//
// A type's own hooks hold in every world. They are a specialisation beside the type, each function if wanted:
//
//   template <>
//   struct lanthorn::ecs::Hooks<Parent> {
//       static void check(const World& world, Entity e, const Parent& value);  // throws to refuse the value
//       static void on_add(World& world, Entity e);
//       static void on_remove(World& world, Entity e);
//       static constexpr bool kReplacesQuietly = true;  // insert over an old value calls neither of them
//   };
//
// Others are given to one world: world.on_add<RigidBody>([&](World& w, Entity e) { ... }); World::unhook ends
// them.
//
// When. on_add comes after the component is there: create, add, insert. on_remove comes before it goes, its
// value still in place: remove, destroy, World::clear. Replacing by insert is on_remove, then on_add; the old
// value dies after that.
// Commands call them when applied. Not called: writing in place (get_mut, Write, Mut), and the end of the
// world itself. `check` comes before anything changes; `e` is null if the entity is still to be made. On an
// add a type's own hook comes first and the world's follow in the order of their giving; on a removal
// likewise.
//
// What a hook may do. Anything to other entities, structure included, whose hooks are called in turn. On an
// add anything to its own entity as well. On a removal its entity must keep its components: to remove or
// destroy it again is an Error. A hook that throws: what was asked for is done (on_add) or not done
// (on_remove), and the exception comes out of the call.
//
// Cost: a flag for each table; where no component of a table has hooks, nothing else.
#pragma once

#include <concepts>
#include <cstdint>
#include <functional>

#include "lanthorn/ecs/entity.h"

namespace lanthorn::ecs {

class World;

template <class T>
struct Hooks {};

// One that a world was given; names it to World::unhook.
struct HookId {
    std::uint64_t number = 0;
};

using Hook = std::function<void(World&, Entity)>;

namespace detail {

template <class T>
concept HasCheck = requires(const World& world, Entity e, const T& value) {
    Hooks<T>::check(world, e, value);
};
template <class T>
concept HasOnAdd = requires(World& world, Entity e) {
    Hooks<T>::on_add(world, e);
};
template <class T>
concept HasOnRemove = requires(World& world, Entity e) {
    Hooks<T>::on_remove(world, e);
};
// Replacing one value by another that `check` lets pass calls no hooks.
template <class T>
concept ReplacesQuietly = requires {
    requires Hooks<T>::kReplacesQuietly;
};

using HookFunction = void (*)(World&, Entity);

template <class T>
constexpr HookFunction add_hook() {
    if constexpr (HasOnAdd<T>) {
        return &Hooks<T>::on_add;
    } else {
        return nullptr;
    }
}

template <class T>
constexpr HookFunction remove_hook() {
    if constexpr (HasOnRemove<T>) {
        return &Hooks<T>::on_remove;
    } else {
        return nullptr;
    }
}

}  // namespace detail
}  // namespace lanthorn::ecs
