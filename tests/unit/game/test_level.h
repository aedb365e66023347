// A level small enough to reckon with: a floor, a wall along Z at x = 0 with a doorway 1 m wide around z = 0,
// a door in it that opens to +X, a lantern beside the player, who looks at the door from x = -2. And a game
// played in it.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include "game/presentation/playthrough.h"
#include "game/rules/components.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/spawn.h"
#include "tools/scene_generator/builder.h"

namespace lanthorn::game {

inline constexpr const char* kTestDoor = R"({"door":{"open_angle":1.9},"body":{"type":"kinematic"}})";

// A leaf from its hinge along +Z, 1 m wide and 2 m high.
inline std::uint32_t add_door(scene_generator::Builder& b, const std::string& name, const dvec3& hinge,
                              const char* extras = kTestDoor) {
    return b.solid(name, scene_generator::box({-0.03, 0.01, 0}, {0.03, 2, 1}), 0, extras,
                   scene_generator::at(hinge));
}

inline void add_player(scene_generator::Builder& b, const dvec3& feet) {
    const std::uint32_t player = b.node("player", scene_generator::at(feet));
    b.scene.nodes[player].extras = R"({"player":{},"character":{"radius":0.28,"height":1.75}})";
    const std::uint32_t eyes =
        b.camera("eyes", scene_generator::looking({0, 1.62, 0}, {1, 1.62, 0}), glm::radians(62.0f));
    b.scene.nodes[eyes].parent = player;
    b.scene.nodes[eyes].extras = R"({"eyes":{}})";
}

inline scene_generator::Builder test_level() {
    using scene_generator::box;
    scene_generator::Builder b;
    b.scene.source = "test.glb";
    const std::uint32_t grey = b.matte("grey", vec3(0.5f));
    b.solid("floor", box({-20, -0.1, -20}, {20, 0, 20}), grey, scene_generator::kBoxCollider);
    b.solid("wall", box({-0.1, 0, 0.5}, {0.1, 3, 4.5}), grey, scene_generator::kBoxCollider);
    b.solid("other-wall", box({-0.1, 0, -4.5}, {0.1, 3, -0.5}), grey, scene_generator::kBoxCollider);
    add_door(b, "door", {0, 0, -0.5});
    const std::uint32_t lantern = b.solid("lantern", box({-0.07, 0, -0.07}, {0.07, 0.22, 0.07}), grey,
                                          R"({"lantern":{}})", scene_generator::at({-1.2, 0, 0.5}));
    Light flame;
    flame.intensity = 15;
    b.light("flame", scene_generator::at({0, 0.11, 0}), flame, lantern);
    add_player(b, {-2, 0, 0});
    const std::uint32_t sensor = b.node("far", scene_generator::looking({4, 1, 0}, {0, 1, 0}));
    b.scene.nodes[sensor].extras = R"({"light_sensor":{"radius":1},"goal":{"lux":2}})";
    return b;
}

inline Options test_options(int threads = 1) {
    Options options;
    options.threads = threads;
    return options;
}

// A session whose player does what the test says.
class Played {
  public:
    explicit Played(const SceneData& scene, const Options& options = test_options())
        : playthrough(options, scene) {
        playthrough.set_devices([this] { return input_; });
    }

    void steps(int count, const PlayerInput& input = {}) {
        input_ = input;
        for (int i = 0; i < count; ++i) {
            session.app().step();
        }
    }
    void press(Button button) {
        PlayerInput input;
        input.held = button;
        steps(1, input);
        steps(1);
    }
    void walk(double forward, int count) {
        PlayerInput input;
        input.forward = axis(forward);
        steps(count, input);
    }
    void turn(double yaw) {
        PlayerInput input;
        input.yaw = input::turn_units(yaw);
        steps(1, input);
    }

    ecs::World& world() { return session.app().world(); }
    ecs::Entity named(const char* name) { return find_by_name(world(), name); }
    template <class T>
    const T& of(const char* name) {
        return world().get<T>(named(name));
    }
    dvec3 place(const char* name) { return of<LocalTransform>(name).value.translation; }

    Playthrough playthrough;
    session::Session& session = playthrough.session();

  private:
    PlayerInput input_;
};

}  // namespace lanthorn::game
