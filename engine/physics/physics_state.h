// What Physics holds: Bullet's world, and the bodies and characters in it.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/physics/body_shape.h"
#include "engine/physics/character_motion.h"
#include "engine/physics/continuous_world.h"
#include "engine/physics/placement.h"
#include "lanthorn/ecs/kept_query.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/physics/physics.h"

namespace lanthorn::physics {

// What a step may touch. What it adds or removes comes with the commands, after the step.
struct Access {
    const ecs::World& world;
    const Physics::Writes& writes;
    ecs::Commands& commands;

    // Writes the component, or has it inserted where the entity lacks it and still lives by then.
    template <class T>
    void put(ecs::Entity e, const T& value) const {
        if (T* known = writes.try_get_mut<T>(e)) {
            *known = value;
            return;
        }
        commands.run([e, value](ecs::World& w) {
            if (w.alive(e)) {
                w.insert(e, T(value));
            }
        });
    }
};

struct Physics::State {
    struct Body {
        ecs::Entity entity;
        RigidBody description;
        bool from_collider = false;  // a Collider alone
        Shape shape;
        glm::dmat3 stretch{1};
        dmat4 placed{1};  // of static and kinematic ones: the WorldTransform last read
        BodyMotion told;  // of dynamic ones: what the world was told last
        std::unique_ptr<btMotionState> motion_state;
        std::unique_ptr<btRigidBody> body;
    };
    struct Walker {
        ecs::Entity entity;
        Character description;
        std::unique_ptr<btCapsuleShape> shape;
        std::unique_ptr<btCollisionObject> object;
        std::unique_ptr<CharacterMotion> motion;
        CharacterState told;  // what the world was told last
    };

    explicit State(const PhysicsSettings& the_settings);
    ~State();

    // A warning is kept once, however often its cause comes back.
    void warn(const ecs::World& w, ecs::Entity e, const std::string& problem);

    // Which entities take part.
    void follow_world(const Access& a, ecs::Tick now);
    void read_entity(const Access& a, ecs::Entity e);
    void join(const dvec3& position);
    bool dynamic(ecs::Entity e) const;
    // What is wrong with a component, whoever made it; empty: nothing.
    template <class T>
    static std::string problem_of(const T& component) {
        const ecs::ComponentType& type = *declared().find<T>();
        const std::string wrong = ecs::problem_of(type, &component);
        return wrong.empty() ? "" : type.name + "." + wrong + ": skipped";
    }
    static const ecs::Registry& declared();
    void clear();
    Shape first_shape(const Access& a, ecs::Entity e, const RigidBody& description, const glm::dmat3& stretch,
                      std::string& problem);

    void add_body(const Access& a, ecs::Entity e, const RigidBody& description, bool from_collider);
    void remove_body(std::uint32_t index);
    enum class Taken { nothing, speeds, all };
    Taken read_motion(const Access& a, Body& body);
    bool read_place(const Access& a, Body& body);
    void start_afresh();
    void tell_motion(const Access& a, Body& body);
    void wake_neighbours(const btCollisionObject& of);
    void read_body(const Access& a, Body& body);
    void write_body(const Access& a, Body& body);

    void add_character(const Access& a, ecs::Entity e, const Character& description);
    void remove_character(std::uint32_t index);
    void move_character(const Access& a, Walker& walker);

    btCollisionObject* object_of(ecs::Entity e) const;  // of a body or a character; null for any other entity
    ecs::Entity entity_of(const btCollisionObject& object) const;

    PhysicsSettings settings;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    ContinuousWorld world;
    std::map<std::uint32_t, Body> bodies;  // by entity index, which is the order of everything done
    std::map<std::uint32_t, Walker> characters;
    std::vector<std::string> warnings;
    dvec3 origin{0};                       // of Bullet's space, in the world
    bool restored = false;                 // a body was put back to another moment since the last step
    bool afresh = false;                   // since the last step all was made again
    std::map<std::uint32_t, Body> before;  // those that are made again, for their shapes
    std::uint64_t world_id = 0;
    ecs::Tick since = 0;
    template <class T>
    using New = ecs::KeptQuery<ecs::With<LocalTransform, WorldTransform>, ecs::Changed<T>>;
    New<RigidBody> new_bodies;
    New<Collider> new_colliders;
    New<Character> new_characters;
};

}  // namespace lanthorn::physics
