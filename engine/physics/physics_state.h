// What Physics holds: Bullet's world, and the bodies and characters in it.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "lanthorn/physics/body_shape.h"
#include "lanthorn/physics/character_motion.h"
#include "lanthorn/physics/physics.h"
#include "lanthorn/physics/placement.h"

namespace lanthorn::physics {

struct Physics::State {
    struct Body {
        ecs::Entity entity;
        BodyDescription description;
        Shape shape;
        glm::dmat3 stretch{1};
        dmat4 placed{1};    // of static and kinematic ones: the WorldTransform last read
        Transform written;  // of dynamic ones: the LocalTransform last read or written
        std::unique_ptr<btMotionState> motion_state;
        std::unique_ptr<btRigidBody> body;
    };
    struct Character {
        ecs::Entity entity;
        CharacterDescription description;
        dvec3 feet{0};  // Bullet's space
        CharacterState state;
        Transform written;
        std::unique_ptr<btCapsuleShape> shape;
        std::unique_ptr<btCollisionObject> object;
        std::unique_ptr<CharacterMotion> motion;
    };

    explicit State(const PhysicsSettings& the_settings);
    ~State();

    // A warning is kept once, however often its cause comes back.
    void warn(const ecs::World& w, ecs::Entity e, const std::string& problem);

    // Which entities take part.
    void follow_world(ecs::World& w);
    void read_entity(ecs::World& w, ecs::Entity e);
    void join(const dvec3& position);
    void clear();

    void add_body(ecs::World& w, ecs::Entity e, const BodyDescription& description);
    void remove_body(std::uint32_t index);
    void wake_neighbours(const btCollisionObject& of);
    void read_body(ecs::World& w, Body& body);
    void write_body(ecs::World& w, Body& body);

    void add_character(ecs::World& w, ecs::Entity e, const CharacterDescription& description);
    void remove_character(std::uint32_t index);
    void move_character(ecs::World& w, Character& character);

    Body* dynamic_body(ecs::Entity e);                  // null for any other entity
    btCollisionObject* object_of(ecs::Entity e) const;  // of a body or a character; null for any other entity
    ecs::Entity entity_of(const btCollisionObject& object) const;

    PhysicsSettings settings;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world;
    std::map<std::uint32_t, Body> bodies;  // by entity index, which is the order of everything done
    std::map<std::uint32_t, Character> characters;
    std::vector<std::string> warnings;
    dvec3 origin{0};  // of Bullet's space, in the world
    std::uint64_t world_id = 0;
    ecs::Tick since = 0;
};

}  // namespace lanthorn::physics
