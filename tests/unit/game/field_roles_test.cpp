// Which fields are the simulation's: an editor neither shows them nor saves them with a level.
#include <gtest/gtest.h>

#include "lanthorn/ecs/component_json.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace {

// "door: angle speed open closed" for every component that has any; "all" where the component itself is.
std::vector<std::string> runtime_fields(const ecs::Registry& registry) {
    std::vector<std::string> lines;
    for (const ecs::ComponentType& type : registry.components()) {
        std::string line;
        for (const ecs::Field& field : type.value->fields) {
            line += field.runtime ? " " + field.name : "";
        }
        if (type.runtime) {
            lines.push_back(type.name + ": all");
        } else if (!line.empty()) {
            lines.push_back(type.name + ":" + line);
        }
    }
    return lines;
}

TEST(FieldRoles, OfEveryComponentOfEngineAndGame) {
    Played game(test_level().scene);
    EXPECT_EQ(runtime_fields(game.session.app().registry()),
              (std::vector<std::string>{
                  "children: all",
                  "world_transform: all",
                  "deformed_meshes: all",
                  "light_sensor: lux readings",
                  "interpolated: all",
                  "animation_player: all",
                  "body_motion: all",
                  "character_input: all",
                  "character_state: all",
                  "player: velocity held",
                  "eyes: yaw pitch",
                  "door: angle speed open closed",
                  "lantern: carried yaw sway sway_speed hand hand_velocity lift flame light",
                  "goal: reached",
                  "shutter: share open shut",
                  "pushed: share start",
                  "turntable: angle start",
                  "crystal: charge awake glowing lamp light",
                  "figure: yaw turning place velocity pace walking",
                  "hand: carrying room figure",
                  "follow_camera: side beside back",
                  "follower: follows velocity trail",
                  "cloth: lengths points speeds still met",
              }));
}

TEST(FieldRoles, ALevelIsSavedAsItWasHoweverFarItIsPlayed) {
    Played game(test_level().scene);
    game.press(kUse);
    game.walk(1, 60);
    EXPECT_GT(game.of<Door>("door").angle, 0.1);
    game.world().query<ecs::Read<Extras>>().each([&](ecs::Entity e, const Extras& extras) {
        EXPECT_EQ(ecs::write_extras(game.session.app().registry(), game.world(), e, extras.json),
                  extras.json);
    });
    const ecs::Entity door = game.named("door");
    game.world().get_mut<Door>(door).open_angle = 1.5;
    EXPECT_EQ(ecs::write_extras(game.session.app().registry(), game.world(), door, kTestDoor),
              R"({"door":{"open_angle":1.5},"body":{"type":"kinematic"}})");
}

}  // namespace
}  // namespace lanthorn::game
