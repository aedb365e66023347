// Commands: structural changes written down now and done later, in the order they were given.
//
// A system takes Commands& and Schedule applies what it wrote at the next sync point; elsewhere:
//   Commands commands(world);  ... inside each(): commands.destroy(e); ...  commands.apply();
// A created entity's handle is good at once as a name (to store, to give further commands); it is alive after
// apply(). Inside Query::parallel_each commands are refused with an Error.
#pragma once

#include <memory>
#include <vector>

#include "lanthorn/ecs/parallel.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::ecs {

class Commands {
  public:
    explicit Commands(World& world) : world_(&world) {}
    Commands(const Commands&) = delete;
    Commands& operator=(const Commands&) = delete;
    ~Commands() { discard(); }

    // An entity with `values` as its components, or with none. The handle is a name until apply().
    template <class... Ts>
    Entity create(Ts&&... values) {
        const Entity e = reserve();
        created_.push_back(e);
        if constexpr (sizeof...(Ts) == 0) {
            record([e](World& world) { world.place(e); });
        } else {
            record([e, held = std::tuple<std::remove_cvref_t<Ts>...>(std::forward<Ts>(values)...)](
                       World& world) mutable {
                std::apply([&](auto&... v) { world.place(e, std::move(v)...); }, held);
            });
        }
        return e;
    }
    // apply() throws an Error for what is dead by then.
    void destroy(Entity e) {
        record([e](World& world) { world.destroy(e); });
    }
    // For what another system may have destroyed as well.
    void destroy_if_alive(Entity e) {
        record([e](World& world) {
            if (world.alive(e)) {
                world.destroy(e);
            }
        });
    }
    // As World::add: apply() throws an Error if the entity is dead or has a T by then.
    template <class T>
    void add(Entity e, T&& value) {
        record([e, held = std::remove_cvref_t<T>(std::forward<T>(value))](World& world) mutable {
            world.add(e, std::move(held));
        });
    }
    // As World::insert, which adds or replaces: apply() throws an Error if the entity is dead by then.
    template <class T>
    void insert(Entity e, T&& value) {
        record([e, held = std::remove_cvref_t<T>(std::forward<T>(value))](World& world) mutable {
            world.insert(e, std::move(held));
        });
    }
    // As World::remove: apply() throws an Error if the entity is dead or has no T by then.
    template <Component T>
    void remove(Entity e) {
        record([e](World& world) { world.remove<T>(e); });
    }
    // As World::insert_resource, which adds or replaces.
    template <class T>
    void insert_resource(T&& value) {
        record([held = std::remove_cvref_t<T>(std::forward<T>(value))](World& world) mutable {
            world.insert_resource(std::move(held));
        });
    }
    // Anything else: fn(World&).
    template <class Fn>
    void run(Fn&& fn) {
        record(std::forward<Fn>(fn));
    }

    bool empty() const { return ops_.empty(); }  // no commands are waiting
    // Does everything. If a command throws, those after it are dropped.
    void apply();
    // Drops everything; entities that were to be created never live.
    void discard() noexcept;

    // For Schedule, when several write commands at once. First fill_pool() for all, then begin_parallel() for
    // all with the table's first_parallel_page(), then the systems, then end_parallel() for all.
    void fill_pool();
    // From here on new entities come from the pool, then from pages that slot `slot` of `slots` has to itself
    // from page `base` on. Touches no table.
    void begin_parallel(std::uint32_t base, std::uint32_t slot, std::uint32_t slots);
    // Makes the numbers that were taken known to the entity table, and gives back what is left of the pool.
    void end_parallel();

  private:
    struct Op {
        void (*run)(void* payload, World& world);
        void (*drop)(void* payload) noexcept;
        void* payload;
    };

    template <class Fn>
    void record(Fn&& fn) {
        detail::check_not_in_parallel_each("give commands");
        using F = std::remove_cvref_t<Fn>;
        ops_.reserve(ops_.size() + 1 > ops_.capacity() ? ops_.size() * 2 + 8 : 0);
        void* at = allocate(sizeof(F), alignof(F));
        ::new (at) F(std::forward<Fn>(fn));
        ops_.push_back({[](void* p, World& world) { (*static_cast<F*>(p))(world); },
                        [](void* p) noexcept { static_cast<F*>(p)->~F(); }, at});
    }
    void* allocate(std::size_t size, std::size_t align);
    Entity reserve();
    void forget() noexcept;
    void return_pool() noexcept;

    World* world_;
    std::vector<Op> ops_;
    std::vector<Entity> created_;
    // Payload memory, kept between uses.
    struct Block {
        std::unique_ptr<std::byte[]> bytes;
        std::size_t size;
    };
    std::vector<Block> blocks_;
    std::size_t block_ = 0;  // the one in use
    std::size_t used_ = 0;   // of it
    // Numbers for the parallel run, so that it need not ask the table; as many as such runs lately took.
    std::vector<Entity> pool_;
    std::size_t pool_next_ = 0;
    std::size_t pool_target_ = 16;
    std::size_t taken_ = 0;
    bool parallel_ = false;
    std::uint32_t base_ = 0, slot_ = 0, slots_ = 1, overflow_ = 0;
};

}  // namespace lanthorn::ecs
