#include "lanthorn/scene/hierarchy.h"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/scene/described.h"

namespace lanthorn {
namespace {

using ecs::Entity;

// `parent` is `e` or below it.
[[noreturn]] void throw_cycle(const ecs::World& world, Entity e, Entity parent) {
    std::string text = "parent: cycle: " + described(world, e);
    for (Entity at = parent; at != e; at = parent_of(world, at)) {
        text += " is below " + described(world, at) + ", which";
    }
    throw ecs::Error(text + " is below " + described(world, e));
}

}  // namespace

Entity parent_of(const ecs::World& world, Entity e) {
    const Parent* parent = world.try_get<Parent>(e);
    return parent && world.alive(parent->entity) ? parent->entity : ecs::kNullEntity;
}

std::span<const Entity> children_of(const ecs::World& world, Entity e) {
    const Children* children = world.try_get<Children>(e);
    return children ? std::span(children->entities) : std::span<const Entity>();
}

void set_parent(ecs::World& world, Entity child, Entity parent) {
    if (!parent) {
        detach(world, child);
        return;
    }
    if (!world.alive(parent)) {
        ecs::World::throw_dead("set_parent", parent);
    }
    world.insert(child, Parent{parent});
}

void detach(ecs::World& world, Entity child) {
    if (!world.alive(child)) {
        ecs::World::throw_dead("detach", child);
    }
    if (world.has<Parent>(child)) {
        world.remove<Parent>(child);
    }
}

void move_child(ecs::World& world, Entity child, std::size_t place) {
    if (!world.alive(child)) {
        ecs::World::throw_dead("move_child", child);
    }
    const Entity parent = parent_of(world, child);
    if (!parent) {
        throw ecs::Error("move_child: " + described(world, child) + " has no parent");
    }
    std::vector<Entity>& list = world.get_mut<Children>(parent).entities;
    list.erase(std::find(list.begin(), list.end(), child));
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(std::min(place, list.size())), child);
}

bool is_within(const ecs::World& world, Entity e, Entity above) {
    Entity at = e;
    while (at && at != above) {
        at = parent_of(world, at);
    }
    return at && world.alive(at);
}

std::vector<Entity> descendants(const ecs::World& world, Entity e) {
    std::vector<Entity> all;
    std::vector<Entity> open;
    const auto push_children = [&](Entity of) {
        const std::span<const Entity> children = children_of(world, of);
        open.insert(open.end(), children.rbegin(), children.rend());
    };
    push_children(e);
    while (!open.empty()) {
        const Entity next = open.back();
        open.pop_back();
        all.push_back(next);
        push_children(next);
    }
    return all;
}

void destroy_tree(ecs::World& world, Entity root) {
    const std::vector<Entity> below = descendants(world, root);
    // From the end every child is the last of its parent's list.
    for (auto e = below.rbegin(); e != below.rend(); ++e) {
        if (world.alive(*e)) {
            world.destroy(*e);
        }
    }
    world.destroy(root);
}

}  // namespace lanthorn

namespace lanthorn::ecs {

void Hooks<Parent>::check(const World& world, Entity e, const Parent& value) {
    if (world.entities().reserved(value.entity)) {
        throw Error("parent: " + to_string(value.entity) + ", the parent of " +
                    (e ? described(world, e) : "a new entity") +
                    ", is still to be created; expected its creation first");
    }
    // Only what has children can be above its own parent.
    if (e && (value.entity == e || (!children_of(world, e).empty() && is_within(world, value.entity, e)))) {
        throw_cycle(world, e, value.entity);
    }
}

void Hooks<Parent>::on_add(World& world, Entity e) {
    const Entity parent = world.get<Parent>(e).entity;
    if (!world.alive(parent)) {
        return;
    }
    Children* children = world.try_get_mut<Children>(parent);
    (children ? *children : world.add(parent, Children{})).entities.push_back(e);
}

void Hooks<Parent>::on_remove(World& world, Entity e) {
    Children* children = world.try_get_mut<Children>(world.get<Parent>(e).entity);
    if (!children) {
        return;
    }
    // Those of a tree that is destroyed leave from the end.
    std::vector<Entity>& list = children->entities;
    if (const auto found = std::find(list.rbegin(), list.rend(), e); found != list.rend()) {
        list.erase(std::next(found).base());
    }
}

void Hooks<Children>::check(const World& world, Entity e, const Children& value) {
    const std::span<const Entity> now = children_of(world, e);
    if (!std::is_permutation(now.begin(), now.end(), value.entities.begin(), value.entities.end())) {
        throw Error("children of " + (e ? described(world, e) : "a new entity") +
                    " cannot be given: they are those that have it as Parent");
    }
}

void Hooks<Children>::on_remove(World& world, Entity e) {
    const std::vector<Entity> orphans = std::exchange(world.get_mut<Children>(e).entities, {});
    for (const Entity child : orphans) {
        if (!world.leaving(child)) {
            world.remove<Parent>(child);
        }
    }
}

}  // namespace lanthorn::ecs
