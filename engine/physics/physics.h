// Rigid bodies and characters (Bullet, double precision). Bodies are entities whose Extras describe one
// (physics_extras.h).
//
//   physics.step(world);       // one fixed step; reads WorldTransform, writes LocalTransform
//   transforms.update(world);  // Transforms brings WorldTransform up to date with it
//
// Static and kinematic bodies stand where their WorldTransform is; kinematic ones push dynamic ones with the
// speed of their own motion. Of dynamic bodies and characters the LocalTransform is written; where somebody
// else wrote it since the last step, they are put there and stand still. An entity that dies or loses its
// Extras takes its body along.
//
// Deterministic: bodies join in the order of their entities' indices, one thread solves in a fixed order, and
// a step has no length but `time_step`. The same calls on the same worlds give the same bits.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/ecs/world.h"
#include "lanthorn/physics/character.h"

namespace lanthorn::physics {

struct PhysicsSettings {
    double time_step = 1.0 / 60;  // seconds, > 0
    dvec3 gravity{0, -9.81, 0};   // m/s^2, world space; characters fall by its Y
    int solver_iterations = 10;   // of the constraint solver, >= 1
};

struct Motion {
    dvec3 linear{0};   // m/s, of the centre of mass
    dvec3 angular{0};  // radians/s, world space
};

// What a moving shape meets.
struct Sweep {
    double share = 1;                    // of the way that is free, 0..1
    ecs::Entity met = ecs::kNullEntity;  // null: nothing
    dvec3 normal{0};                     // of what was met, unit
};

class Physics {
  public:
    // Throws InputError for a setting out of its range.
    explicit Physics(const PhysicsSettings& settings = {});
    ~Physics();
    Physics(const Physics&) = delete;
    Physics& operator=(const Physics&) = delete;

    // One step of the world. WorldTransforms must be up to date. O(bodies and contacts), and what making the
    // shapes of new bodies costs.
    void step(ecs::World& world);

    // What was wrong with bodies and characters: entity, value, what was expected. Such a one is skipped
    // until its Extras are written anew. In the order of its finding, each once.
    const std::vector<std::string>& warnings() const;

    std::size_t body_count() const;
    std::size_t character_count() const;

    // Of a dynamic body; nothing for any other entity.
    std::optional<Motion> motion(ecs::Entity e) const;
    // Gives a dynamic body another motion and wakes it; false for any other entity or a value not finite.
    bool set_motion(ecs::Entity e, const Motion& motion);

    // How far a sphere of `radius` metres gets from one place in the world to another; the bodies of
    // `without` are passed through. Bodies are where the last step left them; one of which the first step is
    // to come is not there yet. O(log bodies) and those along the way.
    Sweep sweep_sphere(const dvec3& from, const dvec3& to, double radius,
                       std::span<const ecs::Entity> without = {}) const;
    // Whether `body`, if it were at an object-to-world matrix of its own scale, would overlap `other`. False
    // where one of them has no body, or `other` is not there yet.
    bool would_overlap(ecs::Entity body, const dmat4& placed, ecs::Entity other) const;
    // The middle of an entity's body in the world, metres; nothing without one.
    std::optional<dvec3> centre(ecs::Entity e) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lanthorn::physics
