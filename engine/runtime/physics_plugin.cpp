#include "engine/runtime/physics_plugin.h"

#include <memory>

#include "engine/physics/declare_components.h"
#include "engine/runtime/transform_system.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/scene/asset_store.h"

namespace lanthorn {

namespace {

using physics::SharedPhysics;

Interpolated from(const LocalTransform& local) {
    return {local.value, local.value, local.value, true, false};
}

// Those that came since it ran last.
void find_movers(
    ecs::Query<ecs::Read<physics::RigidBody>, ecs::Read<LocalTransform>, ecs::Without<Interpolated>,
               ecs::Changed<physics::RigidBody>>
        bodies,
    ecs::Query<ecs::Read<LocalTransform>, ecs::With<physics::Character>, ecs::Without<Interpolated>>
        characters,
    ecs::Commands& commands) {
    bodies.each([&](ecs::Entity e, const physics::RigidBody& body, const LocalTransform& local) {
        if (body.type == physics::BodyType::dynamic) {
            commands.insert(e, from(local));
        }
    });
    characters.each([&](ecs::Entity e, const LocalTransform& local) { commands.insert(e, from(local)); });
}

// What bodies are made of.
void reads_bodies(ecs::Schedule::Config& system) {
    system.reads<physics::RigidBody>()
        .reads<physics::Collider>()
        .reads<physics::Character>()
        .reads<WorldTransform>()
        .reads<Shear>()
        .reads<Parent>()
        .reads<MeshInstances>()
        .reads<Name>()
        .reads_resource<AssetStore>();
}

}  // namespace

PhysicsPlugin::PhysicsPlugin(const physics::PhysicsSettings& settings) : settings_(settings) {
    settings_.time_step = kStepSeconds;
}

void PhysicsPlugin::build(App& app) {
    physics::declare_physics_components(app.registry());
    app.world().insert_resource(SharedPhysics(std::make_shared<physics::Physics>(settings_)));
    ecs::Schedule& fixed = app.fixed_schedule();
    fixed.add("physics.movers", find_movers).in("gameplay");
    const ecs::World& world = app.world();
    ecs::Schedule::Config afresh =
        fixed
            .add("physics.afresh",
                 [&world](ecs::ResMut<SharedPhysics> physics, ecs::Res<Time> time,
                          physics::Physics::Writes writes, ecs::Commands& commands, ecs::SystemTicks ticks) {
                     if (time->at_key_step()) {
                         (*physics)->begin_afresh(world, writes, commands, ticks.now);
                     }
                 })
            .after("restore.transforms")
            .before("gameplay.begin");
    reads_bodies(afresh);
    ecs::Schedule::Config step =
        fixed
            .add("physics",
                 [&world](ecs::ResMut<SharedPhysics> physics, physics::Physics::Writes writes,
                          ecs::Commands& commands,
                          ecs::SystemTicks ticks) { (*physics)->step(world, writes, commands, ticks.now); })
            .after("transforms");
    step.reads<physics::CharacterInput>();
    reads_bodies(step);
    add_transforms(app, fixed, "settle").after("physics").before("remember");
}

}  // namespace lanthorn
