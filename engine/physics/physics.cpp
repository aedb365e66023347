#include "engine/physics/physics.h"

#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/core/error.h"
#include "engine/ecs/query.h"
#include "engine/physics/body_shape.h"
#include "engine/physics/character_motion.h"
#include "engine/physics/placement.h"
#include "engine/scene/spawn.h"
#include "engine/scene/transforms.h"

namespace lanthorn::physics {

namespace {

using ecs::Entity;

constexpr double kSameStretch = 1e-5;  // relative change of scale below which a shape is kept

btVector3 bt(const dvec3& v) {
    return {v.x, v.y, v.z};
}
dvec3 from_bt(const btVector3& v) {
    return {v.x(), v.y(), v.z()};
}
btTransform bt(const dvec3& position, const glm::dquat& rotation) {
    return btTransform(btQuaternion(rotation.x, rotation.y, rotation.z, rotation.w), bt(position));
}
glm::dquat rotation_of(const btTransform& t) {
    const btQuaternion q = t.getRotation();
    return {q.w(), q.x(), q.y(), q.z()};
}

bool is_finite(const dvec3& v) {
    return std::isfinite(v.x + v.y + v.z);
}

bool same_stretch(const glm::dmat3& a, const glm::dmat3& b) {
    double size = 0;
    double difference = 0;
    for (int i = 0; i < 3; ++i) {
        size = std::max(size, glm::length(a[i]));
        difference = std::max(difference, glm::length(a[i] - b[i]));
    }
    return difference <= kSameStretch * size;
}

std::string described(const ecs::World& world, Entity e) {
    const Name* name = world.try_get<Name>(e);
    return name != nullptr ? "'" + name->value + "'" : ecs::to_string(e);
}

// The world matrix as LocalTransform has it now, whether Transforms has run since or not.
dmat4 current_matrix(const ecs::World& world, Entity e) {
    const Shear* shear = world.try_get<Shear>(e);
    const dmat4 local =
        local_matrix(world.get<LocalTransform>(e).value, shear != nullptr ? shear->value : mat3(1));
    const Parent* parent = world.try_get<Parent>(e);
    const WorldTransform* above = parent != nullptr ? world.try_get<WorldTransform>(parent->entity) : nullptr;
    return above != nullptr ? above->matrix * local : local;
}

std::vector<const Mesh*> meshes_of(const ecs::World& world, Entity e) {
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

struct Physics::State {
    struct Body {
        Entity entity;
        BodyDescription description;
        Shape shape;
        glm::dmat3 stretch{1};
        dmat4 placed{1};    // of static and kinematic ones: the WorldTransform last read
        Transform written;  // of dynamic ones: the LocalTransform last read or written
        std::unique_ptr<btMotionState> motion_state;
        std::unique_ptr<btRigidBody> body;
    };
    struct Character {
        Entity entity;
        CharacterDescription description;
        dvec3 feet{0};  // Bullet's space
        CharacterState state;
        Transform written;
        std::unique_ptr<btCapsuleShape> shape;
        std::unique_ptr<btCollisionObject> object;
        std::unique_ptr<CharacterMotion> motion;
    };

    explicit State(const PhysicsSettings& the_settings)
        : settings(the_settings),
          dispatcher(&configuration),
          world(&dispatcher, &broadphase, &solver, &configuration) {
        world.setGravity(bt(settings.gravity));
        world.getSolverInfo().m_numIterations = settings.solver_iterations;
        // However shallow an overlap is, leaving it gives no speed.
        world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
        world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    }
    ~State() {
        while (!bodies.empty()) {
            remove_body(bodies.begin()->first);
        }
        while (!characters.empty()) {
            remove_character(characters.begin()->first);
        }
    }

    void warn(const ecs::World& w, Entity e, const std::string& problem) {
        std::string line = described(w, e) + ": " + problem;
        if (std::ranges::find(warnings, line) == warnings.end()) {
            warnings.push_back(std::move(line));
        }
    }

    void follow_world(ecs::World& w);
    void wake_neighbours(const btCollisionObject& of);
    void join(const dvec3& position);
    void read_entity(ecs::World& w, Entity e);
    void add_body(ecs::World& w, Entity e, const BodyDescription& description);
    void add_character(ecs::World& w, Entity e, const CharacterDescription& description);
    void remove_body(std::uint32_t index);
    void remove_character(std::uint32_t index);
    void read_body(ecs::World& w, Body& body);
    void write_body(ecs::World& w, Body& body);
    void move_character(ecs::World& w, Character& character);
    Body* dynamic_body(Entity e) {
        const auto found = bodies.find(e.index);
        return found != bodies.end() && found->second.entity == e &&
                       found->second.description.type == BodyType::dynamic
                   ? &found->second
                   : nullptr;
    }

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

// The first of all stands near the middle of Bullet's space, whole metres from the world's: what happens
// there does not depend on where in the world it is.
void Physics::State::join(const dvec3& position) {
    if (bodies.empty() && characters.empty()) {
        origin = glm::round(position);
    }
}

void Physics::State::remove_body(std::uint32_t index) {
    const auto found = bodies.find(index);
    wake_neighbours(*found->second.body);
    world.removeRigidBody(found->second.body.get());
    bodies.erase(found);
}

void Physics::State::remove_character(std::uint32_t index) {
    const auto found = characters.find(index);
    world.removeCollisionObject(found->second.object.get());
    characters.erase(found);
}

// Removes what is gone, adds what is new.
void Physics::State::follow_world(ecs::World& w) {
    if (w.id() != world_id) {
        since = 0;
        world_id = w.id();
        while (!bodies.empty()) {
            remove_body(bodies.begin()->first);
        }
        while (!characters.empty()) {
            remove_character(characters.begin()->first);
        }
    }
    std::vector<std::uint32_t> gone;
    const auto lost = [&](Entity e) {
        return !w.has<Extras>(e) || !w.has<LocalTransform>(e) || !w.has<WorldTransform>(e);
    };
    for (const auto& [index, body] : bodies) {
        if (lost(body.entity)) {
            gone.push_back(index);
        }
    }
    for (const std::uint32_t index : gone) {
        remove_body(index);
    }
    gone.clear();
    for (const auto& [index, character] : characters) {
        if (lost(character.entity)) {
            gone.push_back(index);
        }
    }
    for (const std::uint32_t index : gone) {
        remove_character(index);
    }
    std::vector<Entity> fresh =
        w.query<ecs::With<LocalTransform, WorldTransform>, ecs::Changed<Extras>>(since).entities();
    since = w.mark();
    std::ranges::sort(fresh);
    for (const Entity e : fresh) {
        read_entity(w, e);
    }
}

void Physics::State::read_entity(ecs::World& w, Entity e) {
    if (bodies.contains(e.index)) {
        remove_body(e.index);
    }
    if (characters.contains(e.index)) {
        remove_character(e.index);
    }
    const PhysicsExtras extras = read_extras(w.get<Extras>(e).json);
    for (const std::string& problem : extras.problems) {
        warn(w, e, problem);
    }
    if (extras.body) {
        add_body(w, e, *extras.body);
    }
    if (extras.character) {
        add_character(w, e, *extras.character);
    }
}

void Physics::State::add_body(ecs::World& w, Entity e, const BodyDescription& description) {
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

void Physics::State::add_character(ecs::World& w, Entity e, const CharacterDescription& description) {
    const dvec3 feet(current_matrix(w, e)[3]);
    if (!is_finite(feet)) {
        warn(w, e, "has a transform that is not finite, expected a place to stand: skipped");
        return;
    }
    join(feet);
    Character& c = characters[e.index];
    c.entity = e;
    c.description = description;
    c.feet = feet - origin;
    c.state = {};
    c.written = w.get<LocalTransform>(e).value;
    c.shape =
        std::make_unique<btCapsuleShape>(description.radius, description.height - 2 * description.radius);
    c.object = std::make_unique<btCollisionObject>();
    c.object->setCollisionShape(c.shape.get());
    c.object->setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
    c.object->setActivationState(DISABLE_DEACTIVATION);
    c.motion = std::make_unique<CharacterMotion>(world, *c.object, description);
    c.object->setWorldTransform(bt(c.feet + dvec3(0, 0.5 * description.height, 0), {1, 0, 0, 0}));
    world.addCollisionObject(c.object.get(), btBroadphaseProxy::KinematicFilter);
    w.insert(e, CharacterState{});
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
        const Entity e = body.entity;
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

void Physics::State::move_character(ecs::World& w, Character& c) {
    if (!(w.get<LocalTransform>(c.entity).value == c.written)) {
        const dvec3 feet(current_matrix(w, c.entity)[3]);
        if (is_finite(feet)) {
            c.feet = feet - origin;
            c.state = {};
        } else {
            warn(w, c.entity,
                 "was given a transform that is not finite, expected numbers: stays where it was");
        }
    }
    CharacterInput input;
    if (const CharacterInput* given = w.try_get<CharacterInput>(c.entity)) {
        if (is_finite(given->velocity)) {
            input = *given;
        } else {
            warn(w, c.entity, "was given a velocity that is not finite, expected numbers: stands still");
        }
    }
    c.feet = c.motion->step(c.feet, input, -settings.gravity.y, settings.time_step, c.state);
    c.object->setWorldTransform(bt(c.feet + dvec3(0, 0.5 * c.description.height, 0), {1, 0, 0, 0}));
    world.updateSingleAabb(c.object.get());

    Transform local = w.get<LocalTransform>(c.entity).value;
    local.translation = local_of(w, c.entity, c.feet + origin, {1, 0, 0, 0}).translation;
    if (!(local == w.get<LocalTransform>(c.entity).value)) {
        w.get_mut<LocalTransform>(c.entity).value = local;
    }
    c.written = local;
    if (const CharacterState* told = w.try_get<CharacterState>(c.entity);
        told == nullptr || *told != c.state) {
        w.insert(c.entity, CharacterState(c.state));
    }
}

Physics::Physics(const PhysicsSettings& settings) {
    if (!(settings.time_step > 0) || !std::isfinite(settings.time_step)) {
        throw InputError(
            fmt::format("physics: time_step is {}, expected seconds, more than 0", settings.time_step));
    }
    if (!is_finite(settings.gravity)) {
        throw InputError("physics: gravity is not finite, expected three numbers");
    }
    if (settings.solver_iterations < 1) {
        throw InputError(
            fmt::format("physics: solver_iterations is {}, expected 1 or more", settings.solver_iterations));
    }
    state_ = std::make_unique<State>(settings);
}
Physics::~Physics() = default;

void Physics::step(ecs::World& world) {
    State& s = *state_;
    s.follow_world(world);
    std::vector<std::uint32_t> order;  // read_body may put another in a body's place
    for (const auto& [index, body] : s.bodies) {
        order.push_back(index);
    }
    for (const std::uint32_t index : order) {
        s.read_body(world, s.bodies.at(index));
    }
    s.world.stepSimulation(s.settings.time_step, 0);
    std::vector<std::uint32_t> broken;
    for (auto& [index, body] : s.bodies) {
        if (body.description.type != BodyType::dynamic) {
            continue;
        }
        if (!is_finite(from_bt(body.body->getWorldTransform().getOrigin()))) {
            s.warn(world, body.entity, "its body's place was not finite any more, expected numbers: removed");
            broken.push_back(index);
            continue;
        }
        s.write_body(world, body);
    }
    for (const std::uint32_t index : broken) {
        s.remove_body(index);
    }
    for (auto& [index, character] : s.characters) {
        s.move_character(world, character);
    }
}

const std::vector<std::string>& Physics::warnings() const {
    return state_->warnings;
}
std::size_t Physics::body_count() const {
    return state_->bodies.size();
}
std::size_t Physics::character_count() const {
    return state_->characters.size();
}

std::optional<Motion> Physics::motion(ecs::Entity e) const {
    const State::Body* body = state_->dynamic_body(e);
    if (body == nullptr) {
        return std::nullopt;
    }
    return Motion{from_bt(body->body->getLinearVelocity()), from_bt(body->body->getAngularVelocity())};
}

bool Physics::set_motion(ecs::Entity e, const Motion& motion) {
    State::Body* body = state_->dynamic_body(e);
    if (body == nullptr || !is_finite(motion.linear) || !is_finite(motion.angular)) {
        return false;
    }
    body->body->setLinearVelocity(bt(motion.linear));
    body->body->setAngularVelocity(bt(motion.angular));
    body->body->activate(true);
    return true;
}

}  // namespace lanthorn::physics
