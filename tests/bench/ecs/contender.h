// The work that the table of bench_ecs times, as an entity-component system does it: ours, and EnTT where a
// copy of it is given.
#pragma once

#include <cstddef>
#include <memory>

namespace lanthorn::ecs {

struct Position {
    float x = 0, y = 0, z = 0;
};
struct Velocity {
    float x = 1, y = 2, z = 3;
};
struct Heat {
    float value = 1;
};

// What a system does with an entity.
inline void move(Position& p, const Velocity& v) {
    constexpr float dt = 1.0f / 60;
    p.x += v.x * dt;
    p.y += v.y * dt;
    p.z += v.z * dt;
}

// All entities have Position and Velocity, every second one Heat as well. Functions are called in their
// order.
class Contender {
  public:
    Contender() = default;
    Contender(const Contender&) = delete;
    Contender& operator=(const Contender&) = delete;
    virtual ~Contender() = default;

    // Into an empty world.
    virtual void create(std::size_t count) = 0;
    // `move` of all, in the order that is best for it.
    virtual void iterate() = 0;
    // The order of the next two, the same for all contenders; not timed.
    virtual void shuffle() = 0;
    // The velocity of each entity, in random order; returns their sum.
    virtual float get_in_random_order() = 0;
    // Gives Heat to those that have none, and takes it away again: as many operations as there are entities.
    virtual void add_and_remove() = 0;
    // Entity after entity, in the order of creation.
    virtual void destroy() = 0;
};

std::unique_ptr<Contender> make_lanthorn();
std::unique_ptr<Contender> make_entt();  // where LANTHORN_ENTT is set

// Prints the table.
void print_table();

}  // namespace lanthorn::ecs
