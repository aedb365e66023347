// KeptQuery: a query that remembers which tables fit, for code that asks the same again and again outside a
// schedule. A system's Query parameter does the same by itself.
//
//   ecs::KeptQuery<ecs::Write<Position>, ecs::Read<Velocity>> moving_;
//   moving_.in(world).each([](Position& p, const Velocity& v) { ... });
#pragma once

#include "lanthorn/ecs/query.h"

namespace lanthorn::ecs {

// Keeps which tables a query matches, from call to call.
template <class... Terms>
class KeptQuery {
  public:
    // The query over `world` as it is now; `since` is what Changed and Added compare with. It reads what this
    // object keeps: it is valid until in() is called again or the object is moved or destroyed.
    // Cost: one look at each table made since the last call, of all tables if the world is another; allocates
    // only when one of them fits.
    Query<Terms...> in(World& world, Tick since = 0) {
        follow(world);
        return Query<Terms...>(world, state_, since, world.now());
    }
    // Of a world that may only be read: for terms that do not write.
    Query<Terms...> in(const World& world, Tick since = 0) requires detail::kReadOnly<Terms...> {
        follow(world);
        return Query<Terms...>(world, state_, since, world.now());
    }

  private:
    void follow(const World& world) {
        if (world.id() != world_id_) {
            state_ = {};
            world_id_ = world.id();
        }
        state_.update(world);
    }

    std::uint64_t world_id_ = 0;  // 0: none yet
    detail::QueryState<Terms...> state_;
};

}  // namespace lanthorn::ecs
