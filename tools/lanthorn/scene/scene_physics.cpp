#include "tools/lanthorn/scene/scene_physics.h"

#include <algorithm>
#include <cmath>

#include "lanthorn/ecs/query.h"
#include "lanthorn/physics/declare_components.h"
#include "lanthorn/scene/declare_components.h"
#include "lanthorn/scene/extras.h"

namespace lanthorn::tools {

namespace {

constexpr double kStepsPerSecond = 60;  // PhysicsSettings::time_step

bool moves_by_itself(const ecs::World& world, ecs::Entity e) {
    const physics::RigidBody* body = world.try_get<physics::RigidBody>(e);
    return world.has<physics::Character>(e) || (body != nullptr && body->type == physics::BodyType::dynamic);
}

// Steps that are over at `seconds`: k / 60 itself counts as k, however it was rounded.
std::uint64_t steps_until(double seconds) {
    return static_cast<std::uint64_t>(std::floor(seconds * kStepsPerSecond + 1e-6));
}

}  // namespace

const ecs::Registry& shown_components() {
    static const std::unique_ptr<ecs::Registry> kDeclared = [] {
        auto registry = std::make_unique<ecs::Registry>();
        declare_scene_components(*registry);
        physics::declare_physics_components(*registry);
        return registry;
    }();
    return *kDeclared;
}

ScenePhysics::ScenePhysics(ecs::World& world)
    : world_(world), physics_(std::make_unique<physics::Physics>()) {
    const std::vector<ecs::Entity> described = world.query<ecs::With<Extras>>().entities();
    apply_extras(world, shown_components(), described, "", BadExtras::skip);  // load_scene tells what is bad
    world.query<ecs::Read<LocalTransform>>().each([&](ecs::Entity e, const LocalTransform& local) {
        if (moves_by_itself(world, e)) {
            movers_.emplace_back(e, local.value);
        }
    });
}

void ScenePhysics::start_again() {
    steps_ = 0;
    for (const auto& [entity, start] : movers_) {
        world_.get_mut<LocalTransform>(entity).value = start;
        if (world_.has<physics::CharacterState>(entity)) {
            world_.remove<physics::CharacterState>(entity);
        }
        if (world_.has<physics::BodyMotion>(entity)) {
            world_.remove<physics::BodyMotion>(entity);
        }
    }
    physics_ = std::make_unique<physics::Physics>();  // nothing of old speeds and contacts is left
}

void ScenePhysics::run_to(double seconds, const std::function<void(double)>& animate) {
    const std::uint64_t wanted = steps_until(seconds);
    if (wanted < steps_) {
        start_again();
    }
    for (; steps_ < wanted; ++steps_) {
        animate(static_cast<double>(steps_ + 1) / kStepsPerSecond);
        transforms_.update(world_);
        physics_->step(world_);
    }
}

}  // namespace lanthorn::tools
