#include "lanthorn/runtime/shown_scene.h"

#include <algorithm>
#include <utility>

#include "lanthorn/animation/animation_player.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/runtime/interpolation.h"
#include "lanthorn/runtime/scene_plugins.h"

namespace lanthorn {

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

bool has_moving_bodies(ecs::World& world) {
    bool found = !world.query<ecs::With<physics::Character>>().empty();
    world.query<ecs::Read<physics::RigidBody>>().each(
        [&](const physics::RigidBody& body) { found = found || body.type == physics::BodyType::dynamic; });
    return found;
}

}  // namespace

ShownScene::ShownScene(const std::function<void(App&)>& fill) {
    add_scene_plugins(app_);
    fill(app_);
}

ShownScene::ShownScene(SceneData scene, const SceneChoice& choice) {
    const std::string source = scene.source;
    add_scene_plugins(app_);
    if (choice.declare) {
        choice.declare(app_.registry());
    }
    const std::uint32_t camera = find_camera(scene, choice.camera);
    const auto entities = spawn_scene(app_, std::move(scene), BadExtras::skip);
    app_.view().camera = camera == kNone ? ecs::kNullEntity : entities[camera];
    play_clip(world(), choice.animation, source);
    simulates_ = has_moving_bodies(world());
    check_lit_geometry(still_scene(world()), source);
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
    world().insert_resource(SimulatedPose());
    for (const ecs::Entity e : world().query<ecs::With<AnimationPlayer>>().entities()) {
        world().remove<AnimationPlayer>(e);
    }
    for (const ecs::Entity e : world().query<ecs::With<Interpolated>>().entities()) {
        world().remove<Interpolated>(e);
    }
}

std::string ShownScene::state() const {
    return ecs::Snapshot::save(world(), app_.registry()).to_bytes();
}

std::vector<std::string> ShownScene::restore(std::string_view state, std::string_view source) {
    const ecs::Snapshot snapshot = ecs::Snapshot::from_bytes(state, app_.registry(), source);
    snapshot.restore(world());
    return snapshot.left_out();
}

}  // namespace lanthorn
