#include "lanthorn/runtime/animation_plugin.h"

#include "lanthorn/animation/animator.h"
#include "lanthorn/animation/declare_components.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/interpolation.h"

namespace lanthorn {

void AnimationPlugin::build(App& app) {
    declare_animation_components(app.registry());
    app.world().insert_resource(Animator());

    app.fixed_schedule()
        .add("animation",
             [](ecs::World& world) {
                 world.resource_mut<Animator>().animate(world, kStepSeconds,
                                                        world.resource<Time>().simulated());
             })
        .after("gameplay.end")
        .before("transforms");

    app.frame_schedule()
        .add("animation",
             [](ecs::World& world) {
                 const Time& time = world.resource<Time>();
                 SimulatedPose& kept = world.resource_mut<SimulatedPose>();
                 const auto keep = [&kept](ecs::Entity e, const auto& simulated, const auto& shown) {
                     kept.keep(e, simulated, shown);
                 };
                 world.resource_mut<Animator>().show(world, time.ahead(), time.moment, {keep, keep});
             })
        .after("interpolate")
        .before("transforms");
}

}  // namespace lanthorn
