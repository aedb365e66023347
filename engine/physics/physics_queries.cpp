// Questions to the bodies as they stand after the last step.
#include <algorithm>

#include "engine/physics/bullet_types.h"
#include "engine/physics/physics_state.h"

namespace lanthorn::physics {

namespace {

struct NearestOfOthers : btCollisionWorld::ClosestConvexResultCallback {
    NearestOfOthers(const btVector3& from, const btVector3& to, std::vector<const btCollisionObject*> without)
        : ClosestConvexResultCallback(from, to), ignored(std::move(without)) {}

    bool needsCollision(btBroadphaseProxy* proxy) const override {
        const auto* object = static_cast<const btCollisionObject*>(proxy->m_clientObject);
        return std::ranges::find(ignored, object) == ignored.end() &&
               ClosestConvexResultCallback::needsCollision(proxy);
    }

    std::vector<const btCollisionObject*> ignored;
};

struct NearestOnRay : btCollisionWorld::ClosestRayResultCallback {
    NearestOnRay(const btVector3& from, const btVector3& to, const btCollisionObject* without)
        : ClosestRayResultCallback(from, to), ignored(without) {
        m_collisionFilterGroup = btBroadphaseProxy::AllFilter;
        m_collisionFilterMask = btBroadphaseProxy::AllFilter;
    }
    bool needsCollision(btBroadphaseProxy* proxy) const override { return proxy->m_clientObject != ignored; }

    const btCollisionObject* ignored;
};

struct AnyOverlap : btCollisionWorld::ContactResultCallback {
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
        found = found || point.getDistance() < 0;
        return 0;
    }
    bool found = false;
};

}  // namespace

btCollisionObject* Physics::State::object_of(ecs::Entity e) const {
    if (const auto body = bodies.find(e.index); body != bodies.end() && body->second.entity == e) {
        return body->second.body.get();
    }
    if (const auto character = characters.find(e.index);
        character != characters.end() && character->second.entity == e) {
        return character->second.object.get();
    }
    return nullptr;
}

ecs::Entity Physics::State::entity_of(const btCollisionObject& object) const {
    for (const auto& [index, body] : bodies) {
        if (body.body.get() == &object) {
            return body.entity;
        }
    }
    for (const auto& [index, character] : characters) {
        if (character.object.get() == &object) {
            return character.entity;
        }
    }
    return ecs::kNullEntity;
}

Sweep Physics::sweep_sphere(const dvec3& from, const dvec3& to, double radius,
                            std::span<const ecs::Entity> without) const {
    std::vector<const btCollisionObject*> ignored;
    for (const ecs::Entity e : without) {
        ignored.push_back(state_->object_of(e));
    }
    const btVector3 a = bt(from - state_->origin), b = bt(to - state_->origin);
    NearestOfOthers nearest(a, b, std::move(ignored));
    const btSphereShape sphere(radius);
    state_->world.convexSweepTest(&sphere, btTransform(btQuaternion::getIdentity(), a),
                                  btTransform(btQuaternion::getIdentity(), b), nearest);
    if (!nearest.hasHit()) {
        return {};
    }
    return {nearest.m_closestHitFraction, state_->entity_of(*nearest.m_hitCollisionObject),
            from_bt(nearest.m_hitNormalWorld)};
}

std::optional<RayHit> Physics::cast_ray(const dvec3& from, const dvec3& direction, double reach,
                                        ecs::Entity ignored) const {
    const double length = glm::length(direction);
    if (!(length > 0) || !(reach > 0) || !is_finite(from) || !is_finite(direction * reach)) {
        return std::nullopt;
    }
    const btVector3 start = bt(from - state_->origin);
    const btVector3 end = start + bt(direction * (reach / length));
    NearestOnRay hit(start, end, state_->object_of(ignored));
    state_->world.rayTest(start, end, hit);
    if (!hit.hasHit()) {
        return std::nullopt;
    }
    return RayHit{state_->entity_of(*hit.m_collisionObject), reach * hit.m_closestHitFraction,
                  from_bt(hit.m_hitPointWorld) + state_->origin, from_bt(hit.m_hitNormalWorld)};
}

bool Physics::would_overlap(ecs::Entity body, const dmat4& placed, ecs::Entity other) const {
    btCollisionObject* there = state_->object_of(other);
    const auto found = state_->bodies.find(body.index);
    if (there == nullptr || found == state_->bodies.end() || found->second.entity != body) {
        return false;
    }
    const Placement at = placement_of(placed);
    if (!is_finite(at)) {
        return false;
    }
    const Shape& shape = found->second.shape;
    btCollisionObject probe;
    probe.setCollisionShape(shape.shape.get());
    probe.setWorldTransform(bt(at.position - state_->origin + at.rotation * shape.centre, at.rotation));
    AnyOverlap overlap;
    state_->world.contactPairTest(&probe, there, overlap);
    return overlap.found;
}

std::optional<dvec3> Physics::centre(ecs::Entity e) const {
    const btCollisionObject* object = state_->object_of(e);
    if (object == nullptr) {
        return std::nullopt;
    }
    return from_bt(object->getWorldTransform().getOrigin()) + state_->origin;
}

}  // namespace lanthorn::physics
