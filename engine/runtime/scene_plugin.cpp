#include "lanthorn/runtime/scene_plugin.h"

#include "engine/runtime/transform_system.h"
#include "engine/runtime/view_cameras.h"
#include "engine/scene/declare_components.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/scene/asset_store.h"
#include "lanthorn/scene/extract.h"
#include "lanthorn/scene/light_sensor.h"
#include "lanthorn/scene/transforms.h"

namespace lanthorn {

namespace {

using ecs::Commands;
using ecs::Query;
using ecs::Read;
using ecs::Res;
using ecs::ResMut;
using ecs::World;
using ecs::Write;

using Poses = SimulatedPose::Poses;

// Applied at the sync point that follows.
void add_missing(Query<ecs::With<LocalTransform>, ecs::Without<WorldTransform>> fresh, Commands& commands) {
    for (const ecs::Entity e : fresh.entities()) {
        commands.add(e, WorldTransform{});
    }
}

// What a picture between two steps has made of the world is undone before the next step reads it.
void restore(ResMut<SimulatedPose> kept, Query<Write<Interpolated>, Read<LocalTransform>> interpolated,
             Poses poses) {
    kept->restore(poses);
    interpolated.each([&](ecs::Entity e, Interpolated& pose, const LocalTransform& at) {
        Transform local = at.value;
        if (restore_pose(pose, local)) {
            poses.try_get_mut<LocalTransform>(e)->value = local;
        }
    });
}

void remember(Query<Write<Interpolated>, Read<LocalTransform>> poses) {
    poses.each([](Interpolated& pose, const LocalTransform& local) { remember_pose(pose, local.value); });
}

void interpolate(Res<Time> time, ResMut<SimulatedPose> kept,
                 Query<Write<Interpolated>, Read<LocalTransform>> interpolated, Poses poses) {
    kept->restore(poses);
    interpolated.each([&](ecs::Entity e, Interpolated& pose, const LocalTransform& at) {
        Transform local = at.value;
        if (show_pose(pose, time->blend, local)) {
            poses.try_get_mut<LocalTransform>(e)->value = local;
        }
    });
}

void add_extract(App& app) {
    const World& world = app.world();
    app.frame_schedule()
        .add("extract",
             [&world](Res<View> view, Res<Views>, ResMut<Extractor> extractor, ResMut<FrameScene> scene) {
                 check_cameras(world);
                 if (std::optional<CameraView> placed = view->placed) {
                     placed->camera.y_fov = view->y_fov.value_or(placed->camera.y_fov);
                     *scene = extractor->extract(world, *placed);
                 } else {
                     *scene = extractor->extract(world, camera_entity(world, *view), view->y_fov);
                 }
             })
        .reads<MeshInstances>()
        .reads<DeformedMeshes>()
        .reads<LightComponent>()
        .reads<LightSensor>()
        .reads<CameraComponent>()
        .reads<WorldTransform>()
        .reads<LocalTransform>()
        .reads<Parent>()
        .reads<Name>()
        .reads_resource<AssetStore>();
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
    add_transforms(app, fixed, "restore.transforms").after("restore");
    fixed.add_group("gameplay");
    fixed.add_sync_point("gameplay.begin").before("gameplay");
    fixed.add_sync_point("gameplay.end").after("gameplay");
    fixed.add("transforms.missing", add_missing).skip_if_empty();
    fixed.add_sync_point("transforms.begin");
    add_transforms(app, fixed, "transforms");
    fixed.add("remember", remember).after("transforms");

    ecs::Schedule& frame = app.frame_schedule();
    frame.add("transforms.missing", add_missing).skip_if_empty();
    frame.add_sync_point("transforms.begin");
    frame.add("interpolate", interpolate);
    add_transforms(app, frame, "transforms").after("interpolate");
    frame.add_sync_point("extract.begin");
    add_extract(app);
}

}  // namespace lanthorn
