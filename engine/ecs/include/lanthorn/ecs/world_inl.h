// Templates of World.
#pragma once

#include "lanthorn/ecs/world.h"

namespace lanthorn::ecs {

template <class T, class V>
T& World::construct(void* at, V&& value) {
    return *::new (at) T(std::forward<V>(value));
}

template <class... Ts>
const World::Bundle& World::bundle() {
    static const TypeId id = detail::next_bundle_id();
    if (id >= bundles_.size()) {
        bundles_.resize(id + 1);
    }
    Bundle& b = bundles_[id];
    if (!b.archetype) {
        const std::array<const ComponentInfo*, sizeof...(Ts)> infos{&component_info<Ts>()...};
        fill_bundle(b, infos);
    }
    return b;
}

template <class... Ts>
void World::place(Entity e, Ts&&... values) {
    (check_value<std::remove_cvref_t<Ts>>(e, values), ...);
    const Bundle& b = bundle<std::remove_cvref_t<Ts>...>();
    Archetype& archetype = *b.archetype;
    const std::uint32_t row = archetype.push(e, row_tick(tick_));
    [[maybe_unused]] std::size_t i = 0;
    (construct<std::remove_cvref_t<Ts>>(archetype.data(row, b.columns[i++]), std::forward<Ts>(values)), ...);
    entities_.record(e.index).place = archetype.place(row);
    ++alive_;
    if (archetype.hooked) {
        announce_created(e, archetype);
    }
}

template <class... Ts>
Entity World::create(Ts&&... values) {
    constexpr bool cannot_throw = (std::is_nothrow_constructible_v<std::remove_cvref_t<Ts>, Ts&&> && ...);
    if constexpr (!cannot_throw && (std::is_reference_v<Ts> || ...)) {
        // Copies that may throw are made before anything in the world changes.
        return create(std::remove_cvref_t<Ts>(std::forward<Ts>(values))...);
    } else {
        check_unlocked("create an entity");
        bundle<std::remove_cvref_t<Ts>...>();  // may throw
        (check_value<std::remove_cvref_t<Ts>>(kNullEntity, values), ...);
        const Entity e = entities_.reserve();
        place(e, std::forward<Ts>(values)...);
        return e;
    }
}

template <class... Ts>
std::vector<Entity> World::create_many(std::size_t count, const Ts&... values) {
    check_unlocked("create entities");
    std::vector<Entity> made;
    made.reserve(count);
    for (std::size_t n = 0; n < count; ++n) {
        made.push_back(create(values...));
    }
    return made;
}

template <Component T>
const T* World::try_get(Entity e) const {
    const TypeId id = component_info<T>().id;
    const EntityTable::Record* r = entities_.find(e);
    if (!r) {
        return nullptr;
    }
    const ChunkPool::Chunk& chunk = pool_.chunk_at(r->place);
    const std::uint32_t values = chunk.archetype->data_offset(id);
    return values == 0 ? nullptr
                       : reinterpret_cast<const T*>(chunk.memory + values) + ChunkPool::in_chunk(r->place);
}

template <Component T>
T* World::try_get_mut(Entity e) {
    return write<T>(e, row_tick(tick_));
}

template <Component T>
T* World::write(Entity e, RowTick now) const {
    const TypeId id = component_info<T>().id;
    const EntityTable::Record* r = entities_.find(e);
    if (!r) {
        return nullptr;
    }
    const ChunkPool::Chunk& chunk = pool_.chunk_at(r->place);
    const int column = chunk.archetype->column(id);
    if (column == Archetype::kNoColumn) {
        return nullptr;
    }
    const std::uint32_t i = ChunkPool::in_chunk(r->place);
    chunk.archetype->mark_changed_in(chunk.memory, i, column, now);
    const Archetype::Column& c = chunk.archetype->columns()[static_cast<std::size_t>(column)];
    return reinterpret_cast<T*>(chunk.memory + c.data) + i;
}

template <Component T>
const T& World::get(Entity e) const {
    const T* value = try_get<T>(e);
    if (!value) {
        throw_absent("get", e, name_of<T>());
    }
    return *value;
}

template <Component T>
T& World::get_mut(Entity e) {
    T* value = try_get_mut<T>(e);
    if (!value) {
        throw_absent("get", e, name_of<T>());
    }
    return *value;
}

template <class T>
std::remove_cvref_t<T>& World::add(Entity e, T&& value) {
    using C = std::remove_cvref_t<T>;
    check_unlocked("add a component");
    EntityTable::Record& r = live("add", e);
    if (archetype_at(r).has(component_info<C>().id)) {
        throw_double(e, name_of<C>());
    }
    // The value may live in the row that is about to move.
    C held(std::forward<T>(value));
    check_value<C>(e, held);
    C& added = construct<C>(add_raw(e, r, component_info<C>()), std::move(held));
    if (!hooked(component_info<C>())) {
        return added;
    }
    announce_added(e, component_info<C>());
    return after_hooks<C>(e);
}

template <class T>
T& World::after_hooks(Entity e) {
    const T* value = try_get<T>(e);
    if (!value) {
        throw_taken_by_hook(e, name_of<T>());
    }
    return *const_cast<T*>(value);
}

template <class T>
std::remove_cvref_t<T>& World::insert(Entity e, T&& value) {
    using C = std::remove_cvref_t<T>;
    if (hooked(component_info<C>()) && has<C>(e)) {
        check_unlocked("replace a component that has hooks");
        C held(std::forward<T>(value));
        check_value<C>(e, held);
        if constexpr (!detail::ReplacesQuietly<C>) {
            announce_removal(e, component_info<C>());
        }
        C& present = *try_get_mut<C>(e);
        // Lives until the hooks have seen the new one, which may need what it alone keeps.
        [[maybe_unused]] const C before(std::move(present));
        present.~C();  // NOLINT(bugprone-use-after-move): what was moved from still ends
        construct<C>(&present, std::move(held));
        if constexpr (!detail::ReplacesQuietly<C>) {
            announce_added(e, component_info<C>());
        }
        return after_hooks<C>(e);
    }
    if (C* present = try_get_mut<C>(e)) {
        if constexpr (std::is_assignable_v<C&, T&&>) {
            *present = std::forward<T>(value);
        } else {
            C held(std::forward<T>(value));
            present->~C();
            construct<C>(present, std::move(held));
        }
        return *present;
    }
    return add(e, std::forward<T>(value));
}

template <Component T>
void World::remove(Entity e) {
    check_unlocked("remove a component");
    EntityTable::Record& r = live("remove", e);
    const TypeId id = component_info<T>().id;
    if (!archetype_at(r).has(id)) {
        throw_missing("remove", e, name_of<T>());
    }
    if (hooked(component_info<T>())) {
        announce_removal(e, component_info<T>());
    }
    move_row(e, r, without(archetype_at(r), id));
}

template <Component T>
bool World::changed(Entity e, Tick since) const {
    const Row r = find_component(e, component_info<T>());
    return r &&
           r.archetype->changed_tick(r.row, r.archetype->column(component_info<T>().id)) > relative(since);
}

template <Component T>
bool World::added(Entity e, Tick since) const {
    const Row r = find_component(e, component_info<T>());
    return r && r.archetype->added_tick(r.row, r.archetype->column(component_info<T>().id)) > relative(since);
}

template <class T>
std::remove_cvref_t<T>& World::insert_resource(T&& value) {
    using R = std::remove_cvref_t<T>;
    check_unlocked("insert a resource");
    auto fresh = std::make_unique<R>(std::forward<T>(value));
    ResourceSlot& slot = resource_slot(resource_id<R>());
    if (slot.value) {
        slot.destroy(slot.value);
    }
    slot.value = fresh.release();
    slot.destroy = [](void* p) noexcept { delete static_cast<R*>(p); };
    slot.changed = tick_;
    return *static_cast<R*>(slot.value);
}

template <class T>
void World::remove_resource() {
    check_unlocked("remove a resource");
    ResourceSlot& slot = resource_slot(resource_id<T>());
    if (!slot.value) {
        throw_no_resource(name_of<T>());
    }
    slot.destroy(slot.value);
    slot = {};
}

template <class T>
const T* World::try_resource() const {
    const ResourceSlot* slot = find_resource(resource_id<T>());
    return slot ? static_cast<const T*>(slot->value) : nullptr;
}

template <class T>
const T& World::resource() const {
    const T* value = try_resource<T>();
    if (!value) {
        throw_no_resource(name_of<T>());
    }
    return *value;
}

template <class T>
T* World::find_resource_mut(Tick** changed) {
    const TypeId id = resource_id<T>();
    if (!find_resource(id)) {
        return nullptr;
    }
    if (changed) {
        *changed = &resources_[id].changed;
    }
    return static_cast<T*>(resources_[id].value);
}

template <class T>
T& World::resource_mut() {
    Tick* changed = nullptr;
    T* value = find_resource_mut<T>(&changed);
    if (!value) {
        throw_no_resource(name_of<T>());
    }
    *changed = tick_;
    return *value;
}

template <class T>
bool World::resource_changed(Tick since) const {
    const ResourceSlot* slot = find_resource(resource_id<T>());
    return slot && slot->changed > since;
}

template <class T>
Events<T>& World::events() {
    const TypeId id = event_id<T>();
    if (id >= events_.size()) {
        events_.resize(id + 1);
    }
    if (!events_[id]) {
        events_[id] = std::make_unique<Events<T>>();
    }
    return static_cast<Events<T>&>(*events_[id]);
}

}  // namespace lanthorn::ecs
