#include "lanthorn/physics/physics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/physics/bullet_types.h"
#include "engine/physics/declare_components.h"
#include "engine/physics/physics_state.h"
#include "engine/scene/declare_components.h"
#include "engine/scene/described.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"

namespace lanthorn::physics {

using ecs::Entity;

namespace {

// As many times the iterations solve contacts that nothing is known of, where usually the step before has
// left an estimate.
constexpr int kColdTimes = 30;

}  // namespace

Physics::State::State(const PhysicsSettings& the_settings)
    : settings(the_settings),
      dispatcher(&configuration),
      world(&dispatcher, &broadphase, &solver, &configuration) {
    world.setGravity(bt(settings.gravity));
    world.getSolverInfo().m_numIterations = settings.solver_iterations;
    // However shallow an overlap is, leaving it gives no speed.
    world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
    world.getDispatchInfo().m_deterministicOverlappingPairs = true;
    // All contacts of a box with a triangle at once, where the box's shape is prepared for it.
    world.getDispatchInfo().m_enableSatConvex = true;
}

Physics::State::~State() {
    clear();
}

void Physics::State::clear() {
    while (!bodies.empty()) {
        remove_body(bodies.begin()->first);
    }
    while (!characters.empty()) {
        remove_character(characters.begin()->first);
    }
}

void Physics::State::warn(const ecs::World& w, ecs::Entity e, const std::string& problem) {
    std::string line = described(w, e) + ": " + problem;
    if (std::ranges::find(warnings, line) == warnings.end()) {
        warnings.push_back(std::move(line));
    }
}

// Removes what is gone, adds what is new.
void Physics::State::follow_world(const Access& a, ecs::Tick now) {
    const ecs::World& w = a.world;
    if (w.id() != world_id) {
        since = 0;
        world_id = w.id();
        clear();
    }
    std::vector<Entity> fresh;
    const auto placed = [&](Entity e) { return w.has<LocalTransform>(e) && w.has<WorldTransform>(e); };
    std::vector<std::uint32_t> gone;
    for (const auto& [index, body] : bodies) {
        const Entity e = body.entity;
        if (!placed(e) || !(body.from_collider ? w.has<Collider>(e) : w.has<RigidBody>(e))) {
            gone.push_back(index);
            fresh.push_back(e);
        }
    }
    for (const std::uint32_t index : gone) {
        remove_body(index);
    }
    gone.clear();
    for (const auto& [index, walker] : characters) {
        if (!placed(walker.entity) || !w.has<Character>(walker.entity)) {
            gone.push_back(index);
            fresh.push_back(walker.entity);
        }
    }
    for (const std::uint32_t index : gone) {
        remove_character(index);
    }
    const auto changed = [&](auto& query) {
        const auto found = query.in(w, since).entities();
        fresh.insert(fresh.end(), found.begin(), found.end());
    };
    changed(new_bodies);
    changed(new_colliders);
    changed(new_characters);
    since = now;
    std::ranges::sort(fresh);
    fresh.erase(std::unique(fresh.begin(), fresh.end()), fresh.end());
    for (const Entity e : fresh) {
        if (w.alive(e)) {
            read_entity(a, e);
        }
    }
}

// What the entity's components say, from the start.
void Physics::State::read_entity(const Access& a, Entity e) {
    const ecs::World& w = a.world;
    if (bodies.contains(e.index)) {
        remove_body(e.index);
    }
    if (characters.contains(e.index)) {
        remove_character(e.index);
    }
    const bool placed = w.has<LocalTransform>(e) && w.has<WorldTransform>(e);
    const Character* character = placed ? w.try_get<Character>(e) : nullptr;
    const RigidBody* body = placed ? w.try_get<RigidBody>(e) : nullptr;
    const Collider* collider = placed ? w.try_get<Collider>(e) : nullptr;
    if (character != nullptr) {
        if (body != nullptr || collider != nullptr) {
            warn(w, e, "body beside character, expected one of them: the body skipped");
        }
        add_character(a, e, Character(*character));
    } else if (body != nullptr) {
        add_body(a, e, RigidBody(*body), false);
    } else if (collider != nullptr) {
        add_body(a, e, RigidBody{BodyType::fixed, 1, *collider}, true);
    }
    if (!dynamic(e) && w.has<BodyMotion>(e)) {
        a.commands.run([e](ecs::World& world) {
            if (world.alive(e) && world.has<BodyMotion>(e)) {
                world.remove<BodyMotion>(e);
            }
        });
    }
}

bool Physics::State::dynamic(Entity e) const {
    const auto found = bodies.find(e.index);
    return found != bodies.end() && found->second.entity == e &&
           found->second.description.type == BodyType::dynamic;
}

const ecs::Registry& Physics::State::declared() {
    static const std::unique_ptr<ecs::Registry> kDeclared = [] {
        auto registry = std::make_unique<ecs::Registry>();
        declare_scene_components(*registry);
        declare_physics_components(*registry);
        return registry;
    }();
    return *kDeclared;
}

// The first of all stands near the middle of Bullet's space, whole metres from the world's: what happens
// there does not depend on where in the world it is.
void Physics::State::join(const dvec3& position) {
    if (bodies.empty() && characters.empty()) {
        origin = glm::round(position);
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

void Physics::begin_afresh(ecs::World& world) {
    ecs::Commands commands(world);
    const ecs::Tick now = world.mark();
    begin_afresh(world, Writes(world), commands, now);
    commands.apply();
}

// A state as at the start of a program, so that nothing is left in Bullet.
void Physics::begin_afresh(const ecs::World& world, const Writes& writes, ecs::Commands& commands,
                           ecs::Tick now) {
    auto fresh = std::make_unique<State>(state_->settings);
    fresh->warnings = std::move(state_->warnings);
    for (const auto& [index, body] : state_->bodies) {
        state_->world.removeRigidBody(body.body.get());
    }
    fresh->before = std::move(state_->bodies);
    state_->bodies.clear();
    state_ = std::move(fresh);
    state_->follow_world({world, writes, commands}, now);
    state_->before.clear();
    state_->afresh = true;
}

void Physics::step(ecs::World& world) {
    ecs::Commands commands(world);
    const ecs::Tick now = world.mark();
    step(world, Writes(world), commands, now);
    commands.apply();
}

void Physics::step(const ecs::World& world, const Writes& writes, ecs::Commands& commands, ecs::Tick now) {
    State& s = *state_;
    const Access access{world, writes, commands};
    s.follow_world(access, now);
    std::vector<std::uint32_t> order;  // read_body may put another in a body's place
    for (const auto& [index, body] : s.bodies) {
        order.push_back(index);
    }
    for (const std::uint32_t index : order) {
        s.read_body(access, s.bodies.at(index));
    }
    if (s.restored) {
        s.start_afresh();
        s.restored = false;
    }
    s.world.getSolverInfo().m_numIterations = s.settings.solver_iterations * (s.afresh ? kColdTimes : 1);
    s.afresh = false;
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
        s.write_body(access, body);
    }
    for (const std::uint32_t index : broken) {
        s.remove_body(index);
    }
    for (auto& [index, walker] : s.characters) {
        s.move_character(access, walker);
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

}  // namespace lanthorn::physics
