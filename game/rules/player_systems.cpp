// The player looks about and walks.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "game/rules/systems.h"
#include "lanthorn/core/turns.h"

namespace lanthorn::game {

namespace {

constexpr double kReach = 2.2;      // metres to what she can use
constexpr double kMaxPitch = 1.45;  // radians
constexpr double kTakeUp = 0.18;    // of the difference to a new speed that a step takes up

}  // namespace

bool Intent::in_reach(const dvec3& target) const {
    dvec3 way = target - feet;
    way.y = 0;
    const double distance = glm::length(way);
    return distance < kReach && glm::dot(way, facing) > 0.3 * distance;
}

void take_input(Res<PlayerInput> input, Query<Write<Player>, Read<WorldTransform>> players,
                Query<Mut<Eyes>, Mut<LocalTransform>, Read<WorldTransform>> eyes, ResMut<Intent> intent) {
    *intent = {};
    eyes.each([&](ecs::MutRef<Eyes> look, ecs::MutRef<LocalTransform> local, const WorldTransform& world) {
        if (input->yaw != 0 || input->pitch != 0) {
            Eyes& turned = look.write();
            turned.yaw = std::remainder(turned.yaw + input->yaw * input::kTurnUnit, 2 * std::numbers::pi);
            turned.pitch = std::clamp(turned.pitch + input->pitch * input::kTurnUnit, -kMaxPitch, kMaxPitch);
            local.write().value.rotation = quat(about_y(turned.yaw)) * quat(about_x(turned.pitch));
        }
        intent->eye = dvec3(world.matrix[3]);
        intent->yaw = look->yaw;
        intent->facing = look->facing();
    });
    const dvec3 right = glm::cross(intent->facing, dvec3(0, 1, 0));
    players.each([&](Entity e, Player& player, const WorldTransform& world) {
        intent->player = e;
        intent->feet = dvec3(world.matrix[3]);
        const dvec3 wish = intent->facing * (input->forward / 32767.0) + right * (input->right / 32767.0);
        intent->walk = wish * (Player::kSpeed / std::max(1.0, glm::length(wish)));
        intent->pressed = input->held & ~player.held;
        player.held = input->held;
    });
}

void walk(Res<Intent> intent, Query<Write<Player>, Write<physics::CharacterInput>> players) {
    players.each([&](Player& player, physics::CharacterInput& character) {
        player.velocity += kTakeUp * (intent->walk - player.velocity);
        if (intent->walk == dvec3(0) && glm::length(player.velocity) < 1e-2) {
            player.velocity = dvec3(0);
        }
        character.velocity = player.velocity;
    });
}

}  // namespace lanthorn::game
