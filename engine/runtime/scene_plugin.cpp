#include "lanthorn/runtime/scene_plugin.h"

#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/scene/declare_components.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn {

namespace {

using ecs::Query;
using ecs::Res;
using ecs::World;
using ecs::Write;

using Poses = Query<Write<Interpolated>, Write<LocalTransform>>;

void update_transforms(World& world) {
    world.resource_mut<Transforms>().update(world);
}

// What a picture between two steps has made of the world is undone before the next step reads it.
void restore(World& world) {
    SimulatedPose& kept = world.resource_mut<SimulatedPose>();
    bool changed = !kept.empty();
    kept.restore(world);
    for (const ecs::Entity e : world.query<ecs::With<Interpolated, LocalTransform>>().entities()) {
        Interpolated& pose = world.get_mut<Interpolated>(e);
        Transform local = world.get<LocalTransform>(e).value;
        if (restore_pose(pose, local)) {
            world.get_mut<LocalTransform>(e).value = local;
            changed = true;
        }
    }
    if (changed) {
        update_transforms(world);
    }
}

void remember(Query<Write<Interpolated>, ecs::Read<LocalTransform>> poses) {
    poses.each([](Interpolated& pose, const LocalTransform& local) { remember_pose(pose, local.value); });
}

void interpolate(World& world) {
    world.resource_mut<SimulatedPose>().restore(world);
    const double blend = world.resource<Time>().blend;
    for (const ecs::Entity e : world.query<ecs::With<Interpolated, LocalTransform>>().entities()) {
        Transform local = world.get<LocalTransform>(e).value;
        if (show_pose(world.get_mut<Interpolated>(e), blend, local)) {
            world.get_mut<LocalTransform>(e).value = local;
        }
    }
}

void extract(World& world) {
    const View& view = world.resource<View>();
    Extractor& extractor = world.resource_mut<Extractor>();
    world.resource_mut<FrameScene>() =
        view.placed ? extractor.extract(world, *view.placed) : extractor.extract(world, view.camera);
}

}  // namespace

void ScenePlugin::build(App& app) {
    declare_scene_components(app.registry());
    declare_interpolation(app.registry());
    World& world = app.world();
    world.insert_resource(Transforms());
    world.insert_resource(Extractor());
    world.insert_resource(SimulatedPose());
    if (world.try_resource<FrameScene>() == nullptr) {
        world.insert_resource(FrameScene());
    }

    ecs::Schedule& fixed = app.fixed_schedule();
    fixed.add("restore", restore);
    fixed.add_sync_point("gameplay.end");
    fixed.add("transforms", update_transforms);
    fixed.add("remember", remember).after("transforms");

    ecs::Schedule& frame = app.frame_schedule();
    frame.add("interpolate", interpolate);
    frame.add("transforms", update_transforms);
    frame.add("extract", extract);
}

}  // namespace lanthorn
