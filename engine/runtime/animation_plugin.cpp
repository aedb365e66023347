#include "lanthorn/runtime/animation_plugin.h"

#include "lanthorn/animation/animator.h"
#include "lanthorn/animation/declare_components.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/interpolation.h"

namespace lanthorn {

namespace {

using ecs::Res;
using ecs::ResMut;

void step_animation(ResMut<Animator> animator, Res<Time> time, Animator::Players players,
                    Animator::Poses poses) {
    animator->animate(players, poses, kStepSeconds, time->simulated());
}

void show_animation(ResMut<Animator> animator, Res<Time> time, ResMut<SimulatedPose> kept,
                    Animator::Players players, Animator::Poses poses) {
    SimulatedPose& pose = *kept;
    const auto keep = [&pose](ecs::Entity e, const auto& simulated, const auto& shown) {
        pose.keep(e, simulated, shown);
    };
    animator->show(players, poses, time->ahead(), time->moment, {keep, keep});
}

}  // namespace

void AnimationPlugin::build(App& app) {
    declare_animation_components(app.registry());
    app.world().insert_resource(Animator());
    app.fixed_schedule().add("animation", step_animation).after("transforms.begin").before("transforms");
    app.frame_schedule().add("animation", show_animation).after("interpolate").before("transforms");
}

}  // namespace lanthorn
