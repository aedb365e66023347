// Rigid bodies: made, read before a step and written after it.
#include <algorithm>

#include "lanthorn/physics/bullet_types.h"
#include "lanthorn/physics/physics_state.h"
#include "lanthorn/scene/spawn.h"

namespace lanthorn::physics {

namespace {

constexpr double kSameStretch = 1e-5;  // relative change of scale below which a shape is kept

bool same_stretch(const glm::dmat3& a, const glm::dmat3& b) {
    double size = 0;
    double difference = 0;
    for (int i = 0; i < 3; ++i) {
        size = std::max(size, glm::length(a[i]));
        difference = std::max(difference, glm::length(a[i] - b[i]));
    }
    return difference <= kSameStretch * size;
}

std::vector<const Mesh*> meshes_of(const ecs::World& world, ecs::Entity e) {
    std::vector<const Mesh*> meshes;
    const MeshInstances* instances = world.try_get<MeshInstances>(e);
    const SharedAssets* assets = world.try_resource<SharedAssets>();
    if (instances != nullptr && assets != nullptr && *assets) {
        for (const std::uint32_t index : instances->meshes) {
            if (index < (*assets)->meshes.size()) {
                meshes.push_back(&(*assets)->meshes[index]);
            }
        }
    }
    return meshes;
}

}  // namespace

void Physics::State::add_body(ecs::World& w, ecs::Entity e, const BodyDescription& description) {
    const dmat4 matrix = current_matrix(w, e);
    const Placement at = placement_of(matrix);
    if (!physics::is_finite(at)) {
        warn(w, e, "has a transform that is not finite or flattens it, expected one of full rank: skipped");
        return;
    }
    std::string problem;
    Shape shape = make_shape(description, meshes_of(w, e), at.stretch, problem);
    if (!shape.shape) {
        warn(w, e, problem);
        return;
    }
    const bool dynamic = description.type == BodyType::dynamic;
    join(at.position);
    btVector3 inertia(0, 0, 0);
    if (dynamic) {
        shape.shape->calculateLocalInertia(description.mass, inertia);
    }
    Body& body = bodies[e.index];
    body.entity = e;
    body.description = description;
    body.stretch = at.stretch;
    body.placed = matrix;
    body.written = w.get<LocalTransform>(e).value;
    body.shape = std::move(shape);
    const btTransform pose = bt(at.position - origin + at.rotation * body.shape.centre, at.rotation);
    body.motion_state = std::make_unique<btDefaultMotionState>(pose);
    btRigidBody::btRigidBodyConstructionInfo info(dynamic ? description.mass : 0, body.motion_state.get(),
                                                  body.shape.shape.get(), inertia);
    info.m_friction = description.friction;
    info.m_restitution = description.restitution;
    body.body = std::make_unique<btRigidBody>(info);
    if (description.type == BodyType::kinematic) {
        body.body->setCollisionFlags(body.body->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        body.body->setActivationState(DISABLE_DEACTIVATION);
    }
    world.addRigidBody(body.body.get());
}

// What the world says of a body before a step.
void Physics::State::read_body(ecs::World& w, Body& body) {
    const bool dynamic = body.description.type == BodyType::dynamic;
    const Transform& local = w.get<LocalTransform>(body.entity).value;
    if (dynamic ? local == body.written : w.get<WorldTransform>(body.entity).matrix == body.placed) {
        return;
    }
    const dmat4 matrix = dynamic ? current_matrix(w, body.entity) : w.get<WorldTransform>(body.entity).matrix;
    const Placement at = placement_of(matrix);
    if (!physics::is_finite(at)) {
        warn(w, body.entity,
             "was given a transform that is not finite, expected numbers: stays where it was");
        body.body->activate(true);  // so that its own is written again
        return;
    }
    if (!same_stretch(at.stretch, body.stretch)) {
        const ecs::Entity e = body.entity;
        const BodyDescription description = body.description;
        remove_body(e.index);
        add_body(w, e, description);
        return;
    }
    const btTransform pose = bt(at.position - origin + at.rotation * body.shape.centre, at.rotation);
    body.placed = matrix;
    body.written = local;
    body.motion_state->setWorldTransform(pose);
    if (body.description.type == BodyType::kinematic) {
        return;  // Bullet takes the place from the motion state and the speed from the difference
    }
    body.body->setWorldTransform(pose);
    body.body->setInterpolationWorldTransform(pose);
    if (dynamic) {
        body.body->setLinearVelocity({0, 0, 0});
        body.body->setAngularVelocity({0, 0, 0});
        body.body->activate(true);
    } else {
        world.updateSingleAabb(body.body.get());
        wake_neighbours(*body.body);
    }
}

void Physics::State::write_body(ecs::World& w, Body& body) {
    if (!body.body->isActive()) {
        return;
    }
    const btTransform& pose = body.body->getWorldTransform();
    const glm::dquat rotation = rotation_of(pose);
    const dvec3 position = from_bt(pose.getOrigin()) - rotation * body.shape.centre + origin;
    Transform local = local_of(w, body.entity, position, rotation);
    local.scale = body.written.scale;
    body.written = local;
    if (!(local == w.get<LocalTransform>(body.entity).value)) {
        w.get_mut<LocalTransform>(body.entity).value = local;
    }
}

// What lay on it may fall.
void Physics::State::wake_neighbours(const btCollisionObject& of) {
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        if (manifold.getBody0() == &of || manifold.getBody1() == &of) {
            manifold.getBody0()->activate();
            manifold.getBody1()->activate();
        }
    }
}

void Physics::State::remove_body(std::uint32_t index) {
    const auto found = bodies.find(index);
    wake_neighbours(*found->second.body);
    world.removeRigidBody(found->second.body.get());
    bodies.erase(found);
}

Physics::State::Body* Physics::State::dynamic_body(ecs::Entity e) {
    const auto found = bodies.find(e.index);
    return found != bodies.end() && found->second.entity == e &&
                   found->second.description.type == BodyType::dynamic
               ? &found->second
               : nullptr;
}

}  // namespace lanthorn::physics
