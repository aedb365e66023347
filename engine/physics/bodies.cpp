// Rigid bodies: made, read before a step and written after it.
#include <algorithm>
#include <cmath>

#include "engine/physics/bullet_types.h"
#include "engine/physics/physics_state.h"
#include "lanthorn/scene/asset_store.h"

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
    const AssetStore* store = world.try_resource<AssetStore>();
    if (instances != nullptr && store != nullptr) {
        for (const MeshHandle handle : instances->meshes) {
            if (const Mesh* mesh = store->assets().meshes.find(handle); mesh != nullptr) {
                meshes.push_back(mesh);
            }
        }
    }
    return meshes;
}

}  // namespace

// That which it had before it is made afresh, where that would become the same to the bit.
Shape Physics::State::first_shape(const Access& a, ecs::Entity e, const RigidBody& description,
                                  const glm::dmat3& stretch, std::string& problem) {
    const auto old = before.find(e.index);
    if (old != before.end() && old->second.entity == e &&
        old->second.description.collider == description.collider && old->second.stretch == stretch) {
        return std::move(old->second.shape);
    }
    return make_shape(description.collider, meshes_of(a.world, e), stretch, problem);
}

void Physics::State::add_body(const Access& a, ecs::Entity e, const RigidBody& description,
                              bool from_collider) {
    if (const std::string wrong = problem_of(description); !wrong.empty()) {
        warn(a.world, e, wrong);
        return;
    }
    const dmat4 matrix = current_matrix(a.world, e);
    const Placement at = placement_of(matrix);
    if (!physics::is_finite(at)) {
        warn(a.world, e,
             "has a transform that is not finite or flattens it, expected one of full rank: skipped");
        return;
    }
    std::string problem;
    Shape shape = first_shape(a, e, description, at.stretch, problem);
    if (!shape.shape) {
        warn(a.world, e, problem);
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
    body.from_collider = from_collider;
    body.stretch = at.stretch;
    body.placed = matrix;
    body.shape = std::move(shape);
    const btTransform pose = bt(at.position - origin + at.rotation * body.shape.centre, at.rotation);
    body.motion_state = std::make_unique<btDefaultMotionState>(pose);
    btRigidBody::btRigidBodyConstructionInfo info(dynamic ? description.mass : 0, body.motion_state.get(),
                                                  body.shape.shape.get(), inertia);
    info.m_friction = description.collider.friction;
    info.m_restitution = description.collider.restitution;
    body.body = std::make_unique<btRigidBody>(info);
    if (description.type == BodyType::kinematic) {
        body.body->setCollisionFlags(body.body->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        body.body->setActivationState(DISABLE_DEACTIVATION);
    }
    body.body->setUserPointer(&body.shape.core);
    world.addRigidBody(body.body.get());
    if (dynamic) {
        body.told.position = exact_point(from_bt(pose.getOrigin()), origin);
        body.told.rotation = at.rotation;
        body.told.local = a.world.get<LocalTransform>(e).value;
        if (!a.world.has<BodyMotion>(e) || read_motion(a, body) != Taken::all) {
            tell_motion(a, body);
        }
    }
}

// Takes over the BodyMotion that somebody else wrote: a game, or a snapshot.
Physics::State::Taken Physics::State::read_motion(const Access& a, Body& body) {
    const BodyMotion motion = a.world.get<BodyMotion>(body.entity);
    const double turned = glm::dot(motion.rotation, motion.rotation);
    if (!is_finite(motion.linear) || !is_finite(motion.angular) ||
        !is_finite(motion.position.whole + motion.position.rest) || !std::isfinite(turned + motion.still)) {
        warn(a.world, body.entity, "was given a motion that is not finite, expected numbers: keeps its own");
        return Taken::nothing;
    }
    btRigidBody& b = *body.body;
    const bool placed = turned > 0.5 && motion.local == a.world.get<LocalTransform>(body.entity).value;
    b.setLinearVelocity(bt(motion.linear));
    b.setAngularVelocity(bt(motion.angular));
    // Who writes a speed alone wakes the body; a snapshot says what it was.
    const bool wakes = !placed || (motion.position == body.told.position && motion.still == body.told.still &&
                                   motion.rotation == body.told.rotation && motion.rest == body.told.rest);
    restored = restored || !wakes;
    b.setDeactivationTime(wakes ? 0 : motion.still);
    b.forceActivationState(wakes ? ACTIVE_TAG : ACTIVE_TAG + static_cast<int>(motion.rest));
    body.told.linear = motion.linear;
    body.told.angular = motion.angular;
    if (!placed) {
        return Taken::speeds;
    }
    const btTransform pose = bt(relative_to(origin, motion.position), motion.rotation);
    b.setCenterOfMassTransform(pose);
    body.motion_state->setWorldTransform(pose);
    world.updateSingleAabb(&b);
    body.told = motion;
    return Taken::all;
}

// Bullet without its memory of contacts and of who came first: what happens after a snapshot was restored
// depends on the snapshot alone.
void Physics::State::start_afresh() {
    for (auto& [index, body] : bodies) {
        world.removeRigidBody(body.body.get());
    }
    for (auto& [index, walker] : characters) {
        world.removeCollisionObject(walker.object.get());
    }
    broadphase.resetPool(&dispatcher);
    solver.reset();
    for (auto& [index, body] : bodies) {
        world.addRigidBody(body.body.get());
    }
    for (auto& [index, walker] : characters) {
        world.addCollisionObject(walker.object.get(), btBroadphaseProxy::KinematicFilter);
    }
}

// What the world says of a body before a step.
void Physics::State::read_body(const Access& a, Body& body) {
    if (body.description.type != BodyType::dynamic) {
        if (!(a.world.get<WorldTransform>(body.entity).matrix == body.placed)) {
            read_place(a, body);
        }
        return;
    }
    const bool moved = !(a.world.get<LocalTransform>(body.entity).value == body.told.local);
    const BodyMotion* motion = a.world.try_get<BodyMotion>(body.entity);
    const bool pushed = motion != nullptr && *motion != body.told;
    const Taken taken = pushed ? read_motion(a, body) : Taken::nothing;
    if (taken != Taken::all && moved && read_place(a, body) && taken == Taken::nothing) {
        body.body->setLinearVelocity({0, 0, 0});
        body.body->setAngularVelocity({0, 0, 0});
    }
}

// Puts a body where its transform is. False if it was made anew instead, or the transform is of no use.
bool Physics::State::read_place(const Access& a, Body& body) {
    const bool dynamic = body.description.type == BodyType::dynamic;
    const dmat4 matrix =
        dynamic ? current_matrix(a.world, body.entity) : a.world.get<WorldTransform>(body.entity).matrix;
    const Placement at = placement_of(matrix);
    if (!physics::is_finite(at)) {
        warn(a.world, body.entity,
             "was given a transform that is not finite, expected numbers: stays where it was");
        body.body->activate(true);  // so that its own is written again
        return false;
    }
    if (!same_stretch(at.stretch, body.stretch)) {
        const ecs::Entity e = body.entity;
        const RigidBody description = body.description;
        const bool from_collider = body.from_collider;
        remove_body(e.index);
        add_body(a, e, description, from_collider);
        return false;
    }
    const btTransform pose = bt(at.position - origin + at.rotation * body.shape.centre, at.rotation);
    body.placed = matrix;
    body.motion_state->setWorldTransform(pose);
    if (body.description.type == BodyType::kinematic) {
        return true;  // Bullet takes the place from the motion state and the speed from the difference
    }
    body.body->setWorldTransform(pose);
    body.body->setInterpolationWorldTransform(pose);
    if (dynamic) {
        body.told.local = a.world.get<LocalTransform>(body.entity).value;
        body.body->activate(true);
    } else {
        world.updateSingleAabb(body.body.get());
        wake_neighbours(*body.body);
    }
    return true;
}

void Physics::State::write_body(const Access& a, Body& body) {
    btRigidBody& b = *body.body;
    if (b.isActive()) {
        const dvec3 position = from_bt(b.getWorldTransform().getOrigin());
        body.told.position = exact_point(position, origin);
        body.told.rotation = rotation_of(b.getWorldTransform());
        // Bullet goes on with what the world can hold, so that a snapshot has every bit.
        b.setCenterOfMassTransform(bt(position, body.told.rotation));
        const vec3 scale = body.told.local.scale;
        body.told.local =
            local_of(a.world, body.entity, position - body.told.rotation * body.shape.centre + origin,
                     body.told.rotation);
        body.told.local.scale = scale;
        if (!(body.told.local == a.world.get<LocalTransform>(body.entity).value)) {
            a.writes.try_get_mut<LocalTransform>(body.entity)->value = body.told.local;
        }
    }
    tell_motion(a, body);
}

void Physics::State::tell_motion(const Access& a, Body& body) {
    const btRigidBody& b = *body.body;
    body.told.linear = from_bt(b.getLinearVelocity());
    body.told.angular = from_bt(b.getAngularVelocity());
    body.told.still = b.getDeactivationTime();
    const int state = b.getActivationState();
    body.told.rest = state == ISLAND_SLEEPING      ? BodyRest::asleep
                     : state == WANTS_DEACTIVATION ? BodyRest::drowsy
                                                   : BodyRest::awake;
    const BodyMotion* known = a.world.try_get<BodyMotion>(body.entity);
    if (known == nullptr || *known != body.told) {
        a.put(body.entity, body.told);
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

}  // namespace lanthorn::physics
