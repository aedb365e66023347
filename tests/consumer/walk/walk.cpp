// A level to walk about in, with a lantern that a key lights: walk LEVEL.glb
#include <cstdio>
#include <exception>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/physics/components.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/hierarchy.h"
#include "lanthorn/scene/spawn.h"
#include "lanthorn/shell/cameras.h"
#include "lanthorn/shell/window.h"

using namespace lanthorn;
enum class Act { forward, back, left, right, light, leave };
using enum input::Kind;
constexpr input::Action kActs[] = {
    {"forward", "forward", "W", held},    {"back", "back", "S", held},
    {"left", "to the left", "A", held},   {"right", "to the right", "D", held},
    {"light", "the lantern", "F, Pad X"}, {"leave", "leave", "Escape", menu},
};
struct Lantern {};  // 30 candela, or none

void play(ecs::Res<input::Step> step, ecs::Query<ecs::Write<physics::CharacterInput>> feet,
          ecs::Query<ecs::With<CameraComponent, Parent>, ecs::Write<LocalTransform>> eyes,
          ecs::Query<ecs::With<Lantern>, ecs::Write<LightComponent>> lanterns) {
    shell::Gaze gaze;
    eyes.each([&](LocalTransform& at) {
        gaze = shell::gaze_of(at.value.matrix());
        gaze.turn(step->yaw * input::kTurnUnit, step->pitch * input::kTurnUnit);
        at.value.rotation = quat(glm::dmat3(shell::camera_at({}, gaze)));
    });
    feet.each([&](physics::CharacterInput& character) {
        character.velocity = 1.5 * gaze.walk(step->right + step->axis(Act::right, Act::left),
                                             step->forward + step->axis(Act::forward, Act::back));
    });
    if (step->begins(Act::light)) {
        lanterns.each([](LightComponent& lit) { lit.light.intensity = 30 - lit.light.intensity; });
    }
}

int main(int argc, char** argv) try {
    shell::Window window({.title = "walk", .actions = kActs});
    App app;
    add_scene_plugins(app);
    gi::add_picture_plugins(app, window.spending().preset);
    app.add<shell::WindowPlugin>(window);
    app.fixed_schedule().add("play", play).in("gameplay");
    spawn_scene(app, import_gltf(argc > 1 ? argv[1] : ""), BadExtras::skip);
    ecs::World& world = app.world();
    const ecs::Entity walker = world.query<ecs::With<physics::Character>>().entities().at(0);
    const ecs::Entity eyes = app.view().camera = children_of(world, walker)[0];
    world.insert(walker, physics::CharacterInput{});
    world.create(LocalTransform{{.translation = {0.2, -0.3, -0.3}}}, LightComponent{}, Lantern{},
                 Parent{eyes});
    while (window.next_frame() && !window.devices().asked(Act::leave)) window.draw(app);
} catch (const std::exception& e) {
    std::fprintf(stderr, "walk: %s\n", e.what());
    return 2;
}
