// Lookup: components of single entities, as a system's parameter, with the access that a Query would declare.
//
//   void aim(Query<Read<Turret>> turrets, Lookup<Read<WorldTransform>, Write<LocalTransform>> of) {
//       turrets.each([&](const Turret& t) { if (auto* at = of.try_get<WorldTransform>(t.target)) ... });
//   }
//
// For what follows references from entity to entity. O(1): as World::try_get.
#pragma once

#include <type_traits>

#include "lanthorn/ecs/system.h"

namespace lanthorn::ecs {

// Terms are Read<T> and Write<T>, each type once.
template <class... Terms>
class Lookup {
    template <class T>
    static constexpr bool kWrites = (std::is_same_v<Terms, Write<T>> || ...);
    template <class T>
    static constexpr bool kReads = kWrites<T> || (std::is_same_v<Terms, Read<T>> || ...);

  public:
    // Outside a schedule: writes are dated as World's own.
    explicit Lookup(World& world) : Lookup(world, world.now()) {}
    Lookup(World& world, Tick now) : world_(&world), now_(world.row_tick(now)) {}

    // Null if the entity is dead or lacks it.
    template <class T>
    const T* try_get(Entity e) const {
        static_assert(kReads<T>, "not among the types of this Lookup");
        return std::as_const(*world_).template try_get<T>(e);
    }
    // The same; counts as a write.
    template <class T>
    T* try_get_mut(Entity e) const {
        static_assert(kWrites<T>, "not among the types that this Lookup writes");
        return world_->write<T>(e, now_);
    }

  private:
    World* world_;
    RowTick now_;
};

namespace detail {

template <class... Terms>
struct Param<Lookup<Terms...>> {
    static constexpr bool kQuery = false;
    using State = NoState;

    static void declare(SystemAccess& access) { (declare_term(access, static_cast<Terms*>(nullptr)), ...); }
    static void prepare(State&, World&) {}
    static Lookup<Terms...> get(State&, const RunContext& c) { return {c.world, c.ticks.now}; }

  private:
    template <class T>
    static void declare_term(SystemAccess& access, Read<T>*) {
        access.add(SystemAccess::Kind::component, component_info<T>().id, name_of<T>(), false);
    }
    template <class T>
    static void declare_term(SystemAccess& access, Write<T>*) {
        access.add(SystemAccess::Kind::component, component_info<T>().id, name_of<T>(), true);
    }
};

}  // namespace detail
}  // namespace lanthorn::ecs
