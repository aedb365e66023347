// Rigid bodies and characters (Bullet, double precision) of the entities that have a RigidBody, Collider or
// Character (components.h).
//
//   physics.step(world);       // one fixed step; reads WorldTransform, writes LocalTransform
//   transforms.update(world);  // Transforms brings WorldTransform up to date with it
//
// Static and kinematic bodies stand where their WorldTransform is; kinematic ones push dynamic ones with the
// speed of their own motion. Of dynamic bodies and characters the LocalTransform is written; where somebody
// else wrote it since the last step, they are put there and stand still. An entity that dies or loses its
// component takes its body along. How they move is in BodyMotion and CharacterState.
//
// Deterministic: bodies join in the order of their entities' indices, one thread solves in a fixed order, and
// a step has no length but `time_step`. The same calls on the same worlds give the same bits.
//
// begin_afresh() makes what follows depend on the world alone, so that a snapshot taken before it goes on bit
// for bit, in any Physics. An App does that at its key steps (runtime/time.h).
//
// A world that a snapshot restored (ecs/snapshot.h) goes on from it, the same in every return to it. Bit for
// bit as it went on at first do characters and bodies without contacts; what lies on others has lost the
// solver's memory of its contacts, which is in no component.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lanthorn/core/time_step.h"
#include "lanthorn/ecs/lookup.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::physics {

// Of the whole simulation.
struct PhysicsSettings {
    double time_step = kStepSeconds;  // > 0
    dvec3 gravity{0, -9.81, 0};       // m/s^2, world space; characters fall by its Y
    int solver_iterations = 10;       // of the constraint solver, >= 1
};

// What a ray meets first.
struct RayHit {
    ecs::Entity entity;
    double distance = 0;  // metres
    dvec3 point{0};       // metres, world space
    dvec3 normal{0};      // unit, off what was met
};

// What a moving shape meets.
struct Sweep {
    double share = 1;                    // of the way that is free, 0..1
    ecs::Entity met = ecs::kNullEntity;  // null: nothing
    dvec3 normal{0};                     // of what was met, unit
};

class Physics;
// The simulation of an App: a resource.
using SharedPhysics = std::shared_ptr<Physics>;

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

    // The same as a system: what is written is dated `now`, and what bodies and characters gain or lose comes
    // with `commands`. What it reads of `world`: RigidBody, Collider, Character, CharacterInput,
    // WorldTransform, Shear, Parent, MeshInstances, Name and the resource AssetStore.
    using Writes =
        ecs::Lookup<ecs::Write<LocalTransform>, ecs::Write<BodyMotion>, ecs::Write<CharacterState>>;
    // As above; `writes` gives the components that bodies and characters have already.
    void step(const ecs::World& world, const Writes& writes, ecs::Commands& commands, ecs::Tick now);

    // Makes all bodies and characters again, from their components and transforms, before anything moves:
    // what comes of it depends on nothing that was before but what is in components. The next step finds
    // contacts again, and solves them with more iterations. Costs what the making of new bodies does, but for
    // shapes that are still right.
    void begin_afresh(ecs::World& world);
    // The same as a system; `writes`, `commands` and `now` as in step().
    void begin_afresh(const ecs::World& world, const Writes& writes, ecs::Commands& commands, ecs::Tick now);

    // What was wrong with bodies and characters: entity, value, what was expected. Such a one is skipped
    // until its component is written again. In the order of its finding, each once.
    const std::vector<std::string>& warnings() const;

    std::size_t body_count() const;  // those that are in the simulation, colliders without a RigidBody too
    std::size_t character_count() const;  // those that are in the simulation

    // What a ray meets first: bodies, colliders and characters where the last step left them, but not
    // `ignored`. `direction` need not be a unit vector; nothing for one of no length or not finite, or a
    // `reach` (metres) that is not more than 0. O(log bodies), and the triangles of a mesh.
    std::optional<RayHit> cast_ray(const dvec3& from, const dvec3& direction, double reach,
                                   ecs::Entity ignored = {}) const;

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
