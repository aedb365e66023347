// World: entities, their components, resources and events.
//
// Entities with the same set of components share a table (archetype.h), so that a query runs over plain
// arrays. Structural calls (create, destroy, add, remove, insert of a missing component) move rows between
// tables: they end references to components and throw while a query iterates; Commands does them later. Not
// thread-safe, but for what Schedule does with it.
//
// Costs: get misses the cache twice at most, for the entity's record and for the component; add and remove
// move the entity's other components once; create and destroy cost a few stores a component.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "lanthorn/ecs/archetype.h"
#include "lanthorn/ecs/entity.h"
#include "lanthorn/ecs/entity_table.h"
#include "lanthorn/ecs/error.h"
#include "lanthorn/ecs/events.h"
#include "lanthorn/ecs/query_terms.h"
#include "lanthorn/ecs/type_info.h"

namespace lanthorn::ecs {

template <class... Terms>
class Query;
class Commands;

class World {
  public:
    World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    ~World();

    // Entities. Errors: a dead entity, a repeated component type in `values`.
    template <class... Ts>
    Entity create(Ts&&... values);
    // `count` entities, each with copies of `values`.
    template <class... Ts>
    std::vector<Entity> create_many(std::size_t count, const Ts&... values);
    // Destroys its components and ends its handle. Throws an Error for a dead entity.
    void destroy(Entity e);
    bool alive(Entity e) const { return entities_.find(e) != nullptr; }  // false for the null entity
    std::size_t size() const { return alive_; }                          // living entities
    // Destroys all entities; resources and events stay. Those that have hooks go first, the highest numbers
    // first.
    void clear();

    // Components. `get` and its kin throw if the entity is dead or lacks T; the `_mut` forms count as a
    // write.
    template <Component T>
    bool has(Entity e) const {
        const EntityTable::Record* r = entities_.find(e);
        return r && archetype_at(*r).has(component_info<T>().id);
    }
    // To read. Valid until the structure changes.
    template <Component T>
    const T& get(Entity e) const;
    // To write; counts as a write whether or not the value becomes another.
    template <Component T>
    T& get_mut(Entity e);
    template <Component T>
    const T* try_get(Entity e) const;  // null if dead or without T
    // Null, and no write, if dead or without T.
    template <Component T>
    T* try_get_mut(Entity e);
    // Throws if the entity has a T already.
    template <class T>
    std::remove_cvref_t<T>& add(Entity e, T&& value);
    // Adds or replaces.
    template <class T>
    std::remove_cvref_t<T>& insert(Entity e, T&& value);
    // Throws if the entity has no T.
    template <Component T>
    void remove(Entity e);
    // Names of the entity's components.
    std::vector<std::string_view> component_names(Entity e) const;

    // Hooks of this world (hooks.h); the type's own are called in any case. They hold until unhooked or the
    // world ends; what is there already is not announced.
    template <Component T>
    HookId on_add(Hook hook) {
        return hook_in(component_info<T>(), true, std::move(hook));
    }
    // Called before the component goes, and before its entity does.
    template <Component T>
    HookId on_remove(Hook hook) {
        return hook_in(component_info<T>(), false, std::move(hook));
    }
    // Nothing if it is gone already.
    void unhook(HookId id);
    // Its hooks of removal are being called: it is losing a component, or is being destroyed.
    bool leaving(Entity e) const;

    // Queries (query.h): world.query<Write<Position>, Read<Velocity>, Without<Frozen>>().
    // `since` is what Changed and Added terms compare with.
    template <class... Terms>
    Query<Terms...> query(Tick since = 0);
    // For terms that do not write.
    template <class... Terms>
    Query<Terms...> query(Tick since = 0) const requires detail::kReadOnly<Terms...>;

    // History. mark() ends the present: what happens from now on is 'since' the returned tick.
    Tick mark();
    Tick now() const { return tick_; }  // the present tick, from 1; writes are dated by it
    // T was written, or added, since; false if the entity is dead or lacks T.
    template <Component T>
    bool changed(Entity e, Tick since) const;
    // T was added since; false if the entity is dead or lacks T.
    template <Component T>
    bool added(Entity e, Tick since) const;
    // What is gone has no history: hooks on removal tell of it (hooks.h).

    // Resources: at most one of each type, owned by the world.
    template <class T>
    std::remove_cvref_t<T>& insert_resource(T&& value);  // adds or replaces
    template <class T>
    void remove_resource();  // throws if missing
    template <class T>
    const T& resource() const;  // throws if missing
    template <class T>
    T& resource_mut();  // a write; throws if missing
    // Null if missing. O(1).
    template <class T>
    const T* try_resource() const;
    template <class T>
    bool resource_changed(Tick since) const;  // false if missing

    // Events.
    template <class T>
    Events<T>& events();
    // To be read in this step or the next. Error inside Query::parallel_each.
    template <class T>
    void send(T event) {
        events<T>().send(std::move(event));
    }
    // Drops events of the step before the last. Schedule::run calls it at its start unless asked not to.
    void update_events();

    // What Query, Commands and Schedule are built on.
    // Never the same for two worlds of a process.
    std::uint64_t id() const { return id_; }
    // One a set of components that has been in use, in the order of their making; none ever goes.
    const std::vector<std::unique_ptr<Archetype>>& archetypes() const { return archetypes_; }
    // Where an entity's components are.
    struct Row {
        Archetype* archetype = nullptr;  // null: not alive
        std::uint32_t row = 0;

        explicit operator bool() const { return archetype != nullptr; }
    };
    // O(1); no archetype for a dead entity.
    Row row_of(Entity e) const {
        const EntityTable::Record* r = entities_.find(e);
        return r ? row_at(r->place) : Row{};
    }
    // try_get_mut, dated `now`.
    template <Component T>
    T* write(Entity e, RowTick now) const;
    EntityTable& entities() { return entities_; }              // handles and where they are
    const EntityTable& entities() const { return entities_; }  // the same to read
    // Makes `e`, reserved in entities(), alive with `values`.
    template <class... Ts>
    void place(Entity e, Ts&&... values);
    // Null if absent; `changed` (if asked for) is where a write is to be dated.
    template <class T>
    T* find_resource_mut(Tick** changed = nullptr);
    // A tick as far from the tick base as rows store it, below 0 for what is before all that they know.
    std::int64_t relative(Tick t) const {
        return static_cast<std::int64_t>(t) - static_cast<std::int64_t>(tick_base_);
    }
    // Row form of a tick of the present.
    RowTick row_tick(Tick t) const { return static_cast<RowTick>(t - tick_base_); }
    // Takes `count` ticks for a run of systems; returns the first.
    Tick take_ticks(std::uint64_t count);
    // Starts to count row ticks from `new_base`: history before it reads as unchanged to any later `since`.
    void rebase_ticks(Tick new_base);

    // While one exists structural changes throw: "... while `what`".
    class Lock {
      public:
        explicit Lock(const World& world) : world_(&world) {
            world_->locks_.fetch_add(1, std::memory_order_relaxed);
        }
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;
        ~Lock() { world_->locks_.fetch_sub(1, std::memory_order_relaxed); }

      private:
        const World* world_;
    };
    // A Lock exists: a query is iterating.
    bool locked() const { return locks_.load(std::memory_order_relaxed) != 0; }
    // Throws an Error unless structure may change now.
    void check_unlocked(std::string_view action) const {
        if (locked()) {
            throw_locked(action);
        }
    }
    // It is dead, or has no such component.
    [[noreturn]] void throw_absent(std::string_view action, Entity e, std::string_view component) const;
    // Throws an Error that the entity lacks the component, `action` first: "get: entity 1v1 has no component
    // A".
    [[noreturn]] static void throw_missing(std::string_view action, Entity e, std::string_view component);
    // Throws an Error that the entity is dead, `action` first.
    [[noreturn]] static void throw_dead(std::string_view action, Entity e);

  private:
    friend class Snapshot;  // puts whole tables in place

    struct Bundle {
        Archetype* archetype = nullptr;
        std::vector<int> columns;  // of the bundle's types, in the order of their naming
    };
    struct ResourceSlot {
        void* value = nullptr;
        void (*destroy)(void*) noexcept = nullptr;
        Tick changed = 0;
    };
    // The hooks that the world was given for a component.
    struct GivenHook {
        HookId id;
        std::shared_ptr<const Hook> call;
    };
    struct GivenHooks {
        std::vector<GivenHook> add, remove;
    };
    struct Signature {
        std::size_t operator()(const std::vector<TypeId>& ids) const;
    };

    Row row_at(std::uint32_t place) const { return {pool_.chunk_at(place).archetype, pool_.row_at(place)}; }
    // Row's archetype is null, too, if the entity lacks the component.
    Row find_component(Entity e, const ComponentInfo& info) const {
        const Row r = row_of(e);
        return r && r.archetype->has(info.id) ? r : Row{};
    }
    EntityTable::Record& live(std::string_view action, Entity e) {
        EntityTable::Record* r = entities_.find(e);
        if (!r) {
            throw_dead(action, e);
        }
        return *r;
    }
    Archetype& archetype_at(const EntityTable::Record& r) const { return *pool_.chunk_at(r.place).archetype; }
    template <class... Ts>
    const Bundle& bundle();
    void fill_bundle(Bundle& bundle, std::span<const ComponentInfo* const> infos);
    Archetype& archetype_of(std::vector<const ComponentInfo*> components);
    Archetype& with(Archetype& from, const ComponentInfo& info);
    Archetype& without(Archetype& from, TypeId id);
    // Moves the row to `to`; a component that `to` lacks is destroyed, one that it adds is left raw with new
    // ticks.
    std::uint32_t move_row(Entity e, EntityTable::Record& r, Archetype& to);
    // The raw memory of a component that is new to the entity.
    void* add_raw(Entity e, EntityTable::Record& r, const ComponentInfo& info);
    HookId hook_in(const ComponentInfo& info, bool add, Hook hook);
    bool hooked(const ComponentInfo& info) const {
        return info.on_add || info.on_remove || (info.id < hooks_.size() && hooks_[info.id]);
    }
    template <class T>
    void check_value(Entity e, const T& value) const {
        if constexpr (detail::HasCheck<T>) {
            Hooks<T>::check(*this, e, value);
        }
    }
    // Calls the hooks of a component that the entity has got, or of all that it was made with.
    void announce_added(Entity e, const ComponentInfo& info);
    void announce_created(Entity e, const Archetype& archetype);
    // Calls those of one that it will lose, or of all; throws if a hook changed the entity itself.
    void announce_removal(Entity e, const ComponentInfo& info);
    void announce_destruction(Entity e, const Archetype& archetype);
    void announce_leaving(Entity e, std::span<const ComponentInfo* const> infos);
    void call_hooks(Entity e, const ComponentInfo& info, bool add);
    template <class T>
    T& after_hooks(Entity e);
    ResourceSlot& resource_slot(TypeId id);
    const ResourceSlot* find_resource(TypeId id) const;
    template <class T, class V>
    static T& construct(void* at, V&& value);
    [[noreturn]] static void throw_taken_by_hook(Entity e, std::string_view component);
    [[noreturn]] static void throw_locked(std::string_view action);
    [[noreturn]] static void throw_double(Entity e, std::string_view component);
    [[noreturn]] static void throw_no_resource(std::string_view name);

    std::uint64_t id_ = 0;
    EntityTable entities_;
    std::size_t alive_ = 0;
    ChunkPool pool_;
    std::vector<std::unique_ptr<Archetype>> archetypes_;  // the first holds entities without components
    std::unordered_map<std::vector<TypeId>, Archetype*, Signature> by_signature_;
    std::vector<Bundle> bundles_;
    std::vector<ResourceSlot> resources_;
    std::vector<std::unique_ptr<detail::EventsBase>> events_;
    std::vector<std::unique_ptr<GivenHooks>> hooks_;  // by component id; null: none
    std::uint64_t hooks_given_ = 0;
    std::vector<Entity> leaving_;  // whose hooks of removal are being called
    Tick tick_ = 1;
    Tick tick_base_ = 0;
    mutable std::atomic<int> locks_{0};
};

}  // namespace lanthorn::ecs

#include "lanthorn/ecs/world_inl.h"
