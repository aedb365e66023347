#include "engine/physics/character_motion.h"

#include <algorithm>
#include <cmath>

#include "engine/physics/bullet_types.h"

namespace lanthorn::physics {

namespace {

constexpr int kSlides = 4;         // surfaces that one step may slide along
constexpr int kPushes = 4;         // rounds of leaving solids
constexpr double kSkin = 0.01;     // share of the radius
constexpr double kTinyWay = 1e-9;  // share of the radius that is no way at all

struct NearestButSelf : btCollisionWorld::ClosestConvexResultCallback {
    NearestButSelf(const btVector3& from, const btVector3& to, const btCollisionObject& the_self)
        : ClosestConvexResultCallback(from, to), self(the_self), way(to - from) {}

    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return proxy->m_clientObject != &self && ClosestConvexResultCallback::needsCollision(proxy);
    }
    // What is only touched on the way along or away does not stop it.
    btScalar addSingleResult(btCollisionWorld::LocalConvexResult& result, bool in_world) override {
        const btVector3 normal =
            in_world ? result.m_hitNormalLocal
                     : result.m_hitCollisionObject->getWorldTransform().getBasis() * result.m_hitNormalLocal;
        if (normal.dot(way) >= 0) {
            return m_closestHitFraction;
        }
        return ClosestConvexResultCallback::addSingleResult(result, in_world);
    }

    const btCollisionObject& self;
    btVector3 way;
};

// The way out of everything the capsule is in.
struct Overlaps : btCollisionWorld::ContactResultCallback {
    explicit Overlaps(const btCollisionObject& the_probe, const btCollisionObject& the_self)
        : probe(the_probe), self(the_self) {}

    bool needsCollision(btBroadphaseProxy* proxy) const override {
        return proxy->m_clientObject != &self && ContactResultCallback::needsCollision(proxy);
    }
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper* a, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
        const double depth = -point.getDistance();
        if (depth > deepest) {
            deepest = depth;
            const double side = a->getCollisionObject() == &probe ? 1 : -1;
            out = from_bt(point.m_normalWorldOnB) * side;
        }
        return 0;
    }

    const btCollisionObject& probe;
    const btCollisionObject& self;
    double deepest = 0;
    dvec3 out{0};
};

}  // namespace

CharacterMotion::CharacterMotion(const btCollisionWorld& world, const btCollisionObject& self,
                                 const Character& description)
    : world_(world),
      self_(self),
      description_(description),
      capsule_(description.radius * (1 - kSkin), description.height - 2 * description.radius),
      walkable_(std::cos(description.slope_limit)),
      skin_(kSkin * description.radius) {}

btTransform CharacterMotion::placed(const dvec3& feet) const {
    return btTransform(btMatrix3x3::getIdentity(), bt(feet + dvec3(0, 0.5 * description_.height, 0)));
}

CharacterMotion::Contact CharacterMotion::sweep(const dvec3& feet, const dvec3& way) const {
    const btTransform from = placed(feet);
    const btTransform to = placed(feet + way);
    NearestButSelf nearest(from.getOrigin(), to.getOrigin(), self_);
    world_.convexSweepTest(&capsule_, from, to, nearest);
    if (!nearest.hasHit()) {
        return {};
    }
    return {true, nearest.m_closestHitFraction, glm::normalize(from_bt(nearest.m_hitNormalWorld)),
            from_bt(nearest.m_hitPointWorld)};
}

dvec3 CharacterMotion::advance(const dvec3& feet, const dvec3& way, Contact& contact) const {
    const double length = glm::length(way);
    contact = {};
    if (!(length > kTinyWay * description_.radius)) {
        return feet;
    }
    // The swept capsule is thinner than the character by a skin: it looks ahead by what that is along the
    // way.
    const dvec3 direction = way / length;
    contact = sweep(feet, way + direction * skin_);
    if (!contact.met) {
        return feet + way;
    }
    const double free = contact.share * (length + skin_) - skin_;
    return feet + direction * glm::clamp(free, 0.0, length);
}

dvec3 CharacterMotion::walk(const dvec3& feet, const dvec3& way, bool on_ground) const {
    dvec3 at = feet;
    dvec3 left = way;
    dvec3 last(0);
    for (int slide = 0; slide < kSlides; ++slide) {
        Contact contact;
        const dvec3 reached = advance(at, left, contact);
        left -= reached - at;
        at = reached;
        if (!contact.met) {
            break;
        }
        dvec3 normal = contact.normal;
        if (!walkable(normal)) {
            dvec3 climbed;
            if (on_ground && climb(at, left, climbed)) {
                return climbed;
            }
            // As a wall: what is too steep must not lift it.
            const dvec3 level(normal.x, 0, normal.z);
            if (!(glm::length(level) > 0)) {
                break;
            }
            normal = glm::normalize(level);
        }
        left -= normal * std::min(glm::dot(left, normal), 0.0);
        // In a corner: along both, or not at all.
        if (slide > 0 && glm::dot(left, last) < 0) {
            break;
        }
        last = normal;
    }
    return at;
}

bool CharacterMotion::climb(const dvec3& feet, const dvec3& way, dvec3& result) const {
    const dvec3 level(way.x, 0, way.z);
    if (!(description_.step_height > 0) || !(glm::length(level) > kTinyWay * description_.radius)) {
        return false;
    }
    const dvec3 ahead = glm::normalize(level);
    Contact contact;
    const dvec3 lifted = advance(feet, dvec3(0, description_.step_height, 0), contact);
    const dvec3 over = advance(lifted, level, contact);
    result = advance(over, dvec3(0, -description_.step_height - skin_, 0), contact);
    return contact.met && glm::dot(result - feet, ahead) > 0 && foothold(feet, contact, ahead);
}

// Whether there is level ground beside a contact, towards `side`, no higher than a foot lifts. Bullet rounds
// edges off when it sweeps, so that the upper side is looked for from that height.
bool CharacterMotion::foothold(const dvec3& feet, const Contact& contact, const dvec3& side) const {
    const dvec3 at = contact.point + side * (2 * skin_);
    const btVector3 above(at.x, feet.y + description_.step_height + skin_, at.z);
    const btVector3 below(at.x, at.y - 2 * skin_, at.z);
    btCollisionWorld::ClosestRayResultCallback ground(above, below);
    world_.rayTest(above, below, ground);
    return ground.hasHit() && ground.m_closestHitFraction > 0 &&
           walkable(glm::normalize(from_bt(ground.m_hitNormalWorld)));
}

// Ground is what is level enough, and an edge whose upper side is: there the capsule's round end touches
// steeply.
bool CharacterMotion::carries(const dvec3& feet, const Contact& contact) const {
    if (!contact.met || walkable(contact.normal)) {
        return contact.met;
    }
    const dvec3 outward(contact.point.x - feet.x, 0, contact.point.z - feet.z);
    return glm::length(outward) > 0 && foothold(feet, contact, glm::normalize(outward));
}

dvec3 CharacterMotion::settle(const dvec3& feet, double reach, bool& landed) const {
    Contact contact;
    const dvec3 down = advance(feet, dvec3(0, -reach, 0), contact);
    landed = carries(down, contact);
    return landed ? down : feet;
}

dvec3 CharacterMotion::leave_solids(const dvec3& feet) const {
    dvec3 at = feet;
    btCollisionObject probe;
    probe.setCollisionShape(const_cast<btCapsuleShape*>(&capsule_));  // read alone
    for (int push = 0; push < kPushes; ++push) {
        probe.setWorldTransform(placed(at));
        Overlaps overlaps(probe, self_);
        // The query is not const for the sake of its pair's temporary algorithms; the world stays as it is.
        const_cast<btCollisionWorld&>(world_).contactTest(&probe, overlaps);
        if (!(overlaps.deepest > 0)) {
            break;
        }
        at += overlaps.out * (overlaps.deepest + 0.5 * skin_);
    }
    return at;
}

dvec3 CharacterMotion::step(const dvec3& feet, const CharacterInput& input, double gravity, double dt,
                            CharacterState& state) const {
    dvec3 at = leave_solids(feet);
    const bool stood = state.on_ground;
    const bool jumps = stood && input.jump;
    state.vertical_speed = jumps ? description_.jump_speed : stood ? 0 : state.vertical_speed - gravity * dt;
    state.on_ground = false;

    at = walk(at, dvec3(input.velocity.x, 0, input.velocity.z) * dt, stood && !jumps);
    if (stood && !jumps) {
        // Down steps and slopes as far as a foot reaches; else it falls from the next step on.
        at = settle(at, description_.step_height + 2 * skin_, state.on_ground);
        return at;
    }
    const dvec3 fall(0, state.vertical_speed * dt, 0);
    Contact contact;
    const dvec3 reached = advance(at, fall, contact);
    const dvec3 left = fall - (reached - at);
    at = reached;
    if (!contact.met) {
        return at;
    }
    if (fall.y < 0 && carries(at, contact)) {
        state.on_ground = true;
        state.vertical_speed = 0;
        return at;
    }
    if (fall.y > 0) {
        state.vertical_speed = 0;  // a ceiling
        return at;
    }
    // Too steep to stand on: down along it.
    const dvec3 along = left - contact.normal * glm::dot(left, contact.normal);
    at = advance(at, along, contact);
    if (carries(at, contact)) {
        state.on_ground = true;
        state.vertical_speed = 0;
    }
    return at;
}

}  // namespace lanthorn::physics
