#include "tools/lanthorn/scene/scene_physics.h"

#include <algorithm>
#include <cmath>

#include "lanthorn/ecs/query.h"
#include "lanthorn/physics/physics_extras.h"

namespace lanthorn::tools {

namespace {

constexpr double kStepsPerSecond = 60;  // PhysicsSettings::time_step

bool moves_by_itself(const std::string& extras) {
    const physics::PhysicsExtras found = physics::read_extras(extras);
    return found.character || (found.body && found.body->type == physics::BodyType::dynamic);
}

// Steps that are over at `seconds`: k / 60 itself counts as k, however it was rounded.
std::uint64_t steps_until(double seconds) {
    return static_cast<std::uint64_t>(std::floor(seconds * kStepsPerSecond + 1e-6));
}

}  // namespace

ScenePhysics::ScenePhysics(ecs::World& world)
    : world_(world), physics_(std::make_unique<physics::Physics>()) {
    world.query<ecs::Read<Extras>, ecs::Read<LocalTransform>>().each(
        [&](ecs::Entity e, const Extras& extras, const LocalTransform& local) {
            if (moves_by_itself(extras.json)) {
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
