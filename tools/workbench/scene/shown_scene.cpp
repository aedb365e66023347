#include "lanthorn/workbench/shown_scene.h"

#include <algorithm>
#include <utility>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tools/workbench/scene/chosen_camera.h"

namespace lanthorn::workbench {

namespace {

void check_lit_geometry(const FrameScene& frame, const std::string& source) {
    if (frame.instances.empty()) {
        throw InputError(source, "", "found no geometry, expected triangles to render");
    }
    const bool emits = std::any_of(frame.instances.begin(), frame.instances.end(),
                                   [&](const Instance& i) { return frame.material(i).emits(); });
    if (frame.lights.empty() && !emits && !frame.sky) {
        throw InputError(source, "",
                         "found no light, expected a punctual light, an emissive material or a sky");
    }
}

}  // namespace

ShownScene::ShownScene(SceneData scene, const SceneView& view) {
    const std::string source = scene.source;
    add_scene_plugins(app_);
    if (view.declare) {
        view.declare(app_.registry());
    }
    ecs::World& world = app_.world();
    const std::uint32_t camera = find_camera(scene, view.camera);
    const auto entities =
        spawn_scene(app_, std::move(scene), BadExtras::skip);  // load_scene() tells what is bad
    app_.view().camera = camera == kNone ? ecs::kNullEntity : entities[camera];
    play_clip(world, view.animation, source);
    simulates_ = !world.query<ecs::With<physics::Character>>().empty();
    world.query<ecs::Read<physics::RigidBody>>().each([&](const physics::RigidBody& body) {
        simulates_ = simulates_ || body.type == physics::BodyType::dynamic;
    });
    check_lit_geometry(still_scene(world), source);
}

void ShownScene::show_at(double seconds) {
    // Without bodies the last step is all that a moment depends on.
    const double last_step = seconds - kStepSeconds;
    if (!simulates_ && last_step > app_.time().moment) {
        app_.skip_to(last_step);
    }
    app_.show_at(seconds);
}

void ShownScene::hold() {
    ecs::World& world = app_.world();
    world.insert_resource(SimulatedPose());
    for (const ecs::Entity e : world.query<ecs::With<AnimationPlayer>>().entities()) {
        world.remove<AnimationPlayer>(e);
    }
    for (const ecs::Entity e : world.query<ecs::With<Interpolated>>().entities()) {
        world.remove<Interpolated>(e);
    }
}

}  // namespace lanthorn::workbench
