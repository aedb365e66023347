#include "engine/runtime/animation_plugin.h"

#include "engine/animation/declare_components.h"
#include "engine/animation/property_animator.h"
#include "lanthorn/animation/animator.h"
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

void step_properties(ResMut<PropertyAnimator> animator, Res<Time> time, ResMut<AssetStore> store,
                     PropertyAnimator::Players players, PropertyAnimator::Lamps lamps) {
    animator->animate(players, lamps, *store, 0, time->simulated());
}

void show_properties(ResMut<PropertyAnimator> animator, Res<Time> time, ResMut<SimulatedPose> kept,
                     ResMut<AssetStore> store, PropertyAnimator::Players players,
                     PropertyAnimator::Lamps lamps) {
    SimulatedPose& pose = *kept;
    const auto keep = [&pose](ecs::Entity e, const auto& simulated, const auto& shown) {
        pose.keep(e, simulated, shown);
    };
    const PropertyAnimator::Overwritten overwritten{keep, keep};
    animator->animate(players, lamps, *store, time->ahead(), time->moment, &overwritten);
}

}  // namespace

void AnimationPlugin::build(App& app) {
    declare_animation_components(app.registry());
    app.world().insert_resource(Animator());
    app.world().insert_resource(PropertyAnimator());
    asset_store(app.world());
    app.fixed_schedule().add("animation", step_animation).after("transforms.begin").before("transforms");
    app.fixed_schedule().add("animation.properties", step_properties).after("animation").before("transforms");
    app.frame_schedule().add("animation", show_animation).after("interpolate").before("transforms");
    app.frame_schedule().add("animation.properties", show_properties).after("animation").before("transforms");
}

}  // namespace lanthorn
