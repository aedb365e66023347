// The hierarchy of entities: Parent is set, Children follows from it, and walks go along both.
//
//   set_parent(world, wheel, car);            // or world.insert(wheel, Parent{car})
//   for_each_child(world, car, [](ecs::Entity child) { ... });
//   destroy_tree(world, car);                 // world.destroy(car) alone leaves its children as roots
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lanthorn/ecs/world.h"

namespace lanthorn {

// The entity that this one is fixed to. To alter it, insert another or call set_parent(): Children must
// follow. A parent that is dead counts as none. Refused with an ecs::Error: an entity that is its own parent,
// directly or by way of others (named), and a parent that is still to be created (Commands: give the parent's
// create first).
struct Parent {
    const ecs::Entity entity{};
    bool operator==(const Parent&) const = default;
};

// The entities whose Parent is this one, in their order. Written by the hooks of Parent and move_child()
// alone; stays, empty, when the last child leaves. When its entity is destroyed, or it is removed, the
// children lose their Parent: they become roots.
struct Children {
    std::vector<ecs::Entity> entities;
    bool operator==(const Children&) const = default;
};

// Null for a root, and for one whose parent is dead. O(1).
ecs::Entity parent_of(const ecs::World& world, ecs::Entity e);

// In their order; none for a dead entity. Valid until a Parent or a structure changes. O(1).
std::span<const ecs::Entity> children_of(const ecs::World& world, ecs::Entity e);

// Fixes `child` to `parent` as its last child; to the null entity: to nothing. The LocalTransform stays, so
// that it moves with its new parent's place. Throws ecs::Error for a dead entity and for a cycle. O(siblings
// that it leaves), and O(depth of `parent`) if it has children.
void set_parent(ecs::World& world, ecs::Entity child, ecs::Entity parent);

// Makes it a root; nothing if it is one. O(siblings).
void detach(ecs::World& world, ecs::Entity child);

// Moves it among its siblings to `place`, counted from 0; the last for more than there are. Throws ecs::Error
// for a dead entity or a root. O(siblings).
void move_child(ecs::World& world, ecs::Entity child, std::size_t place);

// Whether `e` is `above` or below it. O(depth).
bool is_within(const ecs::World& world, ecs::Entity e, ecs::Entity above);

// Everything below `e`, parents before their children and siblings in their order. O(descendants).
std::vector<ecs::Entity> descendants(const ecs::World& world, ecs::Entity e);

// Destroys `root` and everything below it, the last descendant first. Throws ecs::Error if `root` is dead.
// O(descendants), and O(siblings of `root`).
void destroy_tree(ecs::World& world, ecs::Entity root);

// fn(child) for each child in its order. fn must not change who is whose child: for that walk a copy.
template <class Fn>
void for_each_child(const ecs::World& world, ecs::Entity e, Fn&& fn) {
    for (const ecs::Entity child : children_of(world, e)) {
        fn(child);
    }
}

// fn(descendant) in the order of descendants(), which are gathered first: fn may change anything.
template <class Fn>
void for_each_descendant(const ecs::World& world, ecs::Entity e, Fn&& fn) {
    for (const ecs::Entity below : descendants(world, e)) {
        fn(below);
    }
}

}  // namespace lanthorn

// Keeps the parent's Children when a Parent comes, is replaced or goes.
template <>
struct lanthorn::ecs::Hooks<lanthorn::Parent> {
    // Throws ecs::Error for a cycle, and for a parent that is reserved but not yet created.
    static void check(const World& world, Entity e, const lanthorn::Parent& value);
    // Makes the entity the last of its parent's Children; nothing for a dead parent.
    static void on_add(World& world, Entity e);
    // Takes it out of its parent's Children, searched from the end. O(siblings).
    static void on_remove(World& world, Entity e);
};

// Inserted over an old value it may only reorder the same children, as restoring a world does.
template <>
struct lanthorn::ecs::Hooks<lanthorn::Children> {
    static constexpr bool kReplacesQuietly = true;
    // Throws ecs::Error unless they are those that have the entity as Parent, in any order.
    static void check(const World& world, Entity e, const lanthorn::Children& value);
    // Those that were its children become roots, but those that are being destroyed too.
    static void on_remove(World& world, Entity e);
};
