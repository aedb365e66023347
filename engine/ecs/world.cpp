#include "lanthorn/ecs/world.h"

#include <algorithm>

namespace lanthorn::ecs {

std::size_t World::Signature::operator()(const std::vector<TypeId>& ids) const {
    std::size_t h = ids.size();
    for (const TypeId id : ids) {
        h = (h ^ id) * 0x9e3779b97f4a7c15ull + (h >> 29);
    }
    return h;
}

World::World() {
    static std::atomic<std::uint64_t> next_id{1};
    id_ = next_id.fetch_add(1, std::memory_order_relaxed);
    archetype_of({});
}

World::~World() {
    for (ResourceSlot& slot : resources_) {
        if (slot.value) {
            slot.destroy(slot.value);
        }
    }
}

Archetype& World::archetype_of(std::vector<const ComponentInfo*> components) {
    std::sort(components.begin(), components.end(),
              [](const ComponentInfo* a, const ComponentInfo* b) { return a->id < b->id; });
    std::vector<TypeId> ids;
    ids.reserve(components.size());
    for (const ComponentInfo* info : components) {
        ids.push_back(info->id);
    }
    Archetype*& found = by_signature_[ids];
    if (!found) {
        archetypes_.push_back(std::make_unique<Archetype>(std::move(components), pool_));
        found = archetypes_.back().get();
        for (const ComponentInfo* info : found->components()) {
            found->hooked = found->hooked || hooked(*info);
        }
    }
    return *found;
}

void World::fill_bundle(Bundle& bundle, std::span<const ComponentInfo* const> infos) {
    for (std::size_t i = 0; i < infos.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (infos[i] == infos[j]) {
                throw Error("create: component " + std::string(infos[i]->name) + " is given twice");
            }
        }
    }
    Archetype& archetype = archetype_of({infos.begin(), infos.end()});
    bundle.columns.clear();
    for (const ComponentInfo* info : infos) {
        bundle.columns.push_back(archetype.column(info->id));
    }
    bundle.archetype = &archetype;
}

Archetype& World::with(Archetype& from, const ComponentInfo& info) {
    if (info.id >= from.with_edges.size()) {
        from.with_edges.resize(info.id + 1);
    }
    Archetype*& to = from.with_edges[info.id];
    if (!to) {
        std::vector<const ComponentInfo*> components = from.components();
        components.push_back(&info);
        to = &archetype_of(std::move(components));
    }
    return *to;
}

Archetype& World::without(Archetype& from, TypeId id) {
    if (id >= from.without_edges.size()) {
        from.without_edges.resize(id + 1);
    }
    Archetype*& to = from.without_edges[id];
    if (!to) {
        std::vector<const ComponentInfo*> components = from.components();
        std::erase_if(components, [id](const ComponentInfo* info) { return info->id == id; });
        to = &archetype_of(std::move(components));
    }
    return *to;
}

std::uint32_t World::move_row(Entity e, EntityTable::Record& r, Archetype& to) {
    Archetype& from = archetype_at(r);
    const std::uint32_t old_row = pool_.row_at(r.place);
    const std::uint32_t row = to.push_raw(e);
    const RowTick now = row_tick(tick_);
    // Both lists of columns are sorted by id: one walk over the two.
    std::size_t f = 0;
    for (std::size_t t = 0; t < to.columns().size(); ++t) {
        const ComponentInfo& info = *to.columns()[t].info;
        while (f < from.columns().size() && from.columns()[f].info->id < info.id) {
            const ComponentInfo& gone = *from.columns()[f].info;
            if (!gone.trivial) {
                gone.destroy(from.data(old_row, static_cast<int>(f)));
            }
            ++f;
        }
        if (f < from.columns().size() && from.columns()[f].info == &info) {
            void* source = from.data(old_row, static_cast<int>(f));
            void* target = to.data(row, static_cast<int>(t));
            if (info.trivial) {
                std::memcpy(target, source, info.size);
            } else {
                info.relocate(target, source);
            }
            to.set_ticks(row, static_cast<int>(t), from.added_tick(old_row, static_cast<int>(f)),
                         from.changed_tick(old_row, static_cast<int>(f)));
            ++f;
        } else {
            to.set_ticks(row, static_cast<int>(t), now, now);
        }
    }
    for (; f < from.columns().size(); ++f) {
        const ComponentInfo& gone = *from.columns()[f].info;
        if (!gone.trivial) {
            gone.destroy(from.data(old_row, static_cast<int>(f)));
        }
    }
    if (const Entity moved = from.remove(old_row, false)) {
        entities_.record(moved.index).place = r.place;
    }
    r.place = to.place(row);
    return row;
}

void* World::add_raw(Entity e, EntityTable::Record& r, const ComponentInfo& info) {
    Archetype& to = with(archetype_at(r), info);
    const std::uint32_t row = move_row(e, r, to);
    return to.data(row, to.column(info.id));
}

void World::destroy(Entity e) {
    check_unlocked("destroy an entity");
    EntityTable::Record& r = live("destroy", e);
    Archetype& archetype = archetype_at(r);
    if (archetype.hooked) {
        announce_destruction(e, archetype);
    }
    if (const Entity moved = archetype.remove(pool_.row_at(r.place), true)) {
        entities_.record(moved.index).place = r.place;
    }
    entities_.release(e);
    --alive_;
}

void World::clear() {
    check_unlocked("clear the world");
    // Hooks may make, move and destroy others: one by one, until there is nobody left who has any.
    for (bool found = true; found;) {
        std::vector<Entity> doomed;
        for (const auto& archetype : archetypes_) {
            if (!archetype->hooked) {
                continue;
            }
            for (std::uint32_t row = 0; row < archetype->size(); ++row) {
                doomed.push_back(archetype->entity(row));
            }
        }
        found = !doomed.empty();
        std::sort(doomed.begin(), doomed.end());
        for (auto e = doomed.rbegin(); e != doomed.rend(); ++e) {
            if (alive(*e)) {
                destroy(*e);
            }
        }
    }
    for (const auto& archetype : archetypes_) {
        for (std::uint32_t row = 0; row < archetype->size(); ++row) {
            entities_.release(archetype->entity(row));
        }
        archetype->clear();
    }
    alive_ = 0;
}

std::vector<std::string_view> World::component_names(Entity e) const {
    const Row r = row_of(e);
    if (!r) {
        throw_dead("component_names", e);
    }
    std::vector<std::string_view> names;
    for (const ComponentInfo* info : r.archetype->components()) {
        names.push_back(info->name);
    }
    return names;
}

Tick World::mark() {
    return take_ticks(1);
}

Tick World::take_ticks(std::uint64_t count) {
    if (tick_ - tick_base_ + count >= 0xffffffffull) {
        rebase_ticks(tick_ - (1ull << 31));
    }
    const Tick first = tick_;
    tick_ += count;
    return first;
}

void World::rebase_ticks(Tick new_base) {
    check_unlocked("rebase ticks");
    if (new_base <= tick_base_ || new_base >= tick_) {
        return;
    }
    const auto delta = static_cast<RowTick>(new_base - tick_base_);
    for (const auto& archetype : archetypes_) {
        archetype->rebase(delta);
    }
    tick_base_ = new_base;
}

World::ResourceSlot& World::resource_slot(TypeId id) {
    if (id >= resources_.size()) {
        resources_.resize(id + 1);
    }
    return resources_[id];
}

const World::ResourceSlot* World::find_resource(TypeId id) const {
    return id < resources_.size() && resources_[id].value ? &resources_[id] : nullptr;
}

void World::update_events() {
    for (const auto& events : events_) {
        if (events) {
            events->update();
        }
    }
}

void World::throw_absent(std::string_view action, Entity e, std::string_view component) const {
    alive(e) ? throw_missing(action, e, component) : throw_dead(action, e);
}

void World::throw_missing(std::string_view action, Entity e, std::string_view component) {
    throw Error(std::string(action) + ": " + to_string(e) + " has no component " + std::string(component));
}

void World::throw_dead(std::string_view action, Entity e) {
    throw Error(std::string(action) + ": " + to_string(e) + " is not alive");
}

void World::throw_double(Entity e, std::string_view component) {
    throw Error("add: " + to_string(e) + " already has component " + std::string(component) +
                " (insert replaces it)");
}

void World::throw_taken_by_hook(Entity e, std::string_view component) {
    throw Error("a hook took the component " + std::string(component) + " from " + to_string(e) +
                " while it was being added");
}

void World::throw_locked(std::string_view action) {
    throw Error("cannot " + std::string(action) + " while a query iterates or systems run; use Commands");
}

void World::throw_no_resource(std::string_view name) {
    throw Error("no resource of type " + std::string(name));
}

}  // namespace lanthorn::ecs
