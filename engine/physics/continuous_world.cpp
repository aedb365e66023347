#include "engine/physics/continuous_world.h"

#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <LinearMath/btTransformUtil.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace lanthorn::physics {

namespace {

constexpr double kFreeWay = 0.5;  // of the half thickness: what contacts of the next step make good
// Stopped by the first core a body overlaps by little: enough for a contact in the next step, and less than
// the margins within which Bullet's contacts are good. What touches at the start (slides, rolls, is pressed
// into another) is swept by the largest of the others that is free: it sinks in from one to the next at most.
constexpr double kFirstCore = 0.95;  // scale of the shape about its middle
constexpr double kInnerCores[] = {0.65, 0.5, 0.35, 0.2, 0.1};
constexpr double kNear = 0.01;                // of the half thickness: what counts as touch
constexpr double kMostTurn = 0.25 * SIMD_PI;  // radians that Bullet turns a body in a step at most

const Core& core_of(const btRigidBody& body) {
    return *static_cast<const Core*>(body.getUserPointer());
}

// What a box in space meets and the body collides with.
struct InTheWay : btBroadphaseAabbCallback {
    InTheWay(const btRigidBody& the_body, btDispatcher& the_dispatcher)
        : body(the_body), dispatcher(the_dispatcher) {}

    bool process(const btBroadphaseProxy* proxy) override {
        auto* other = static_cast<btCollisionObject*>(proxy->m_clientObject);
        const btBroadphaseProxy& own = *body.getBroadphaseHandle();
        if (other != &body && (proxy->m_collisionFilterGroup & own.m_collisionFilterMask) != 0 &&
            (own.m_collisionFilterGroup & proxy->m_collisionFilterMask) != 0 &&
            dispatcher.needsResponse(&body, other)) {
            found.push_back(other);
        }
        return true;
    }

    const btRigidBody& body;
    btDispatcher& dispatcher;
    std::vector<btCollisionObject*> found;
};

// Of all that a motion reaches, in space.
struct MotionBox {
    MotionBox(const Motion& motion, double radius) : lower(motion.from.getOrigin()), upper(lower) {
        lower.setMin(motion.from.getOrigin() + motion.way);
        upper.setMax(motion.from.getOrigin() + motion.way);
        const btVector3 around(radius, radius, radius);
        lower -= around;
        upper += around;
    }
    btVector3 lower;
    btVector3 upper;
};

// One body's sweep: how far it gets.
struct Path {
    const btConvexShape& shape;
    const Core& core;
    const Motion& motion;
    double share = 1;

    // Parts of one body: what slides over a triangle does not catch on the next.
    void meet(const std::vector<Mover>& parts) {
        const double near = kNear * core.half_thickness;
        const Mover whole{&shape, motion, btVector3(0, 0, 0), core.reach};
        bool free = true;
        std::vector<const Mover*> in_reach;
        for (const Mover& part : parts) {
            if (most_way(whole, part) > kFreeWay * core.half_thickness) {
                const auto [distance, closing] = approach(whole, part, 0);
                free = free && distance > near;
                if (distance < closing) {
                    in_reach.push_back(&part);
                }
            }
        }
        for (const Mover* part : in_reach) {
            if (free && meet(*part, kFirstCore, near)) {
                continue;
            }
            for (const double scale : kInnerCores) {
                if (meet(*part, scale, near)) {
                    break;
                }
            }
        }
    }
    // False if the core of this scale is not free at the start.
    bool meet(const Mover& other, double scale, double near) {
        btUniformScalingShape scaled(const_cast<btConvexShape*>(&shape), scale);  // read alone
        const Mover own{&scaled, motion, (1 - scale) * core.middle, core.reach};
        const std::optional<double> touch = first_touch(own, other, near);
        share = std::min(share, touch.value_or(1));
        return touch.has_value();
    }
};

struct Triangles : btTriangleCallback {
    void processTriangle(btVector3* corners, int, int) override {
        found.emplace_back(corners[0], corners[1], corners[2]).setMargin(0);
    }
    std::deque<btTriangleShape> found;
};

// Whether balls about the origins, which hold the shapes however they turn, come together.
bool balls_meet(const Motion& a, double radius_a, const Motion& b, double radius_b) {
    const btVector3 apart = a.from.getOrigin() - b.from.getOrigin();
    const btVector3 way = a.way - b.way;
    const double length2 = way.length2();
    const double nearest = length2 > 0 ? std::clamp(-apart.dot(way) / length2, 0.0, 1.0) : 0;
    return (apart + nearest * way).length() <= radius_a + radius_b;
}

// `box` is that of the path about the start of the other's motion.
void meet_object(Path& path, const btCollisionObject& other, const Motion& motion, const MotionBox& box) {
    const btCollisionShape& shape = *other.getCollisionShape();
    const double reach = shape.getAngularMotionDisc();
    if (!balls_meet(path.motion, path.shape.getAngularMotionDisc(), motion, reach)) {
        return;
    }
    if (shape.isConvex()) {
        path.meet({{static_cast<const btConvexShape*>(&shape), motion, btVector3(0, 0, 0), reach}});
    } else if (shape.isConcave()) {
        Triangles triangles;
        btVector3 lower, upper;
        btTransformAabb(box.lower, box.upper, 0, motion.from.inverse(), lower, upper);
        static_cast<const btConcaveShape&>(shape).processAllTriangles(&triangles, lower, upper);
        std::vector<Mover> parts;
        for (const btTriangleShape& triangle : triangles.found) {
            parts.push_back({&triangle, motion, btVector3(0, 0, 0), reach});
        }
        path.meet(parts);
    }
}

}  // namespace

Motion ContinuousWorld::motion_of(const btRigidBody& body, double time_step) const {
    Motion motion{body.getWorldTransform()};
    if (body.isActive() && !body.isStaticOrKinematicObject()) {
        motion.way = body.getLinearVelocity() * time_step;
        motion.turn = body.getAngularVelocity() * time_step;
        const double turn = motion.turn.length();
        motion.turn *= turn > kMostTurn ? kMostTurn / turn : 1;
    }
    return motion;
}

double ContinuousWorld::free_share(const btRigidBody& body, const Motion& motion, double time_step,
                                   const btCollisionObject* without) {
    const auto& shape = static_cast<const btConvexShape&>(*body.getCollisionShape());
    const MotionBox box(motion, shape.getAngularMotionDisc());
    InTheWay in_the_way(body, *getDispatcher());
    getBroadphase()->aabbTest(box.lower, box.upper, in_the_way);
    Path path{shape, core_of(body), motion};
    for (const btCollisionObject* other : in_the_way.found) {
        if (other != without) {
            const btRigidBody* rigid = btRigidBody::upcast(other);
            meet_object(path, *other,
                        rigid != nullptr ? motion_of(*rigid, time_step) : Motion{other->getWorldTransform()},
                        box);
        }
    }
    return path.share;
}

// What a kinematic body would leap over on its way goes along with the part of it that it meets, as far as
// there is room.
void ContinuousWorld::push_ahead(const btRigidBody& pusher, const btTransform& from) {
    Motion motion{from};
    btTransformUtil::calculateVelocity(from, pusher.getWorldTransform(), 1, motion.way, motion.turn);
    const double radius = pusher.getCollisionShape()->getAngularMotionDisc();
    const double way = motion.way.length() + motion.turn.length() * radius;
    if (!(way > 0) || motion.way.length() > radius || motion.turn.length() > kMostTurn) {
        return;  // put elsewhere
    }
    const MotionBox box(motion, radius);
    InTheWay in_the_way(pusher, *getDispatcher());
    getBroadphase()->aabbTest(box.lower, box.upper, in_the_way);
    for (btCollisionObject* other : in_the_way.found) {
        btRigidBody* body = btRigidBody::upcast(other);
        if (body == nullptr || body->isStaticOrKinematicObject() ||
            !(way > kFreeWay * core_of(*body).half_thickness)) {
            continue;
        }
        const Motion still{body->getWorldTransform()};
        Path path{static_cast<const btConvexShape&>(*body->getCollisionShape()), core_of(*body), still};
        // The pusher's way as that of the body about the pusher's start.
        meet_object(path, pusher, motion, MotionBox(still, path.shape.getAngularMotionDisc() + way));
        if (path.share < 1) {
            const btTransform carried =
                pusher.getWorldTransform() * motion.at(path.share).inverse() * still.from;
            Motion along{still.from};
            btTransformUtil::calculateVelocity(still.from, carried, 1, along.way, along.turn);
            body->proceedToTransform(along.at(free_share(*body, along, 0, &pusher)));
            body->activate(true);
        }
    }
}

void ContinuousWorld::saveKinematicState(btScalar time_step) {
    pushers_.clear();
    for (int i = 0; i < m_collisionObjects.size(); ++i) {
        btRigidBody* body = btRigidBody::upcast(m_collisionObjects[i]);
        if (body != nullptr && body->isKinematicObject()) {
            pushers_.emplace_back(body, body->getInterpolationWorldTransform());
        }
    }
    btDiscreteDynamicsWorld::saveKinematicState(time_step);
    for (const auto& [body, from] : pushers_) {
        push_ahead(*body, from);
    }
}

void ContinuousWorld::integrateTransforms(btScalar time_step) {
    stopped_.clear();
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
        btRigidBody& body = *m_nonStaticRigidBodies[i];
        if (!body.isActive() || body.isStaticOrKinematicObject()) {
            continue;
        }
        const Core& core = core_of(body);
        const double way =
            time_step * (body.getLinearVelocity().length() + body.getAngularVelocity().length() * core.reach);
        if (!(way > kFreeWay * core.half_thickness) || !std::isfinite(way)) {
            continue;
        }
        const Motion motion = motion_of(body, time_step);
        const double share = free_share(body, motion, time_step, nullptr);
        if (share < 1) {
            stopped_.emplace_back(&body, motion.at(share));
        }
    }
    btDiscreteDynamicsWorld::integrateTransforms(time_step);
    for (const auto& [body, pose] : stopped_) {
        body->proceedToTransform(pose);
    }
}

}  // namespace lanthorn::physics
