#include "game/systems.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::game {

namespace {

constexpr double kReach = 2.2;       // metres to the middle of a door's leaf, or to the lantern
constexpr double kMaxPitch = 1.45;   // radians
constexpr double kQuickness = 12;    // 1 / seconds: how fast walking takes up a new speed
constexpr double kSpring = 14;       // 1 / s^2: of the door
constexpr double kHandAhead = 0.42;  // metres from the eye
constexpr double kHandAside = 0.24;
constexpr double kHandBelow = 0.34;
constexpr double kLanternRadius = 0.1;    // metres
constexpr double kPendulum = 9.81 / 0.3;  // 1 / s^2
constexpr double kPendulumDamping = 4;    // 1 / s
constexpr double kMaxSway = 0.45;         // radians

// The walls and the door as it stands.
std::vector<Box> obstacles(const Query<Read<Wall>>& walls, const Query<Read<Door>, Read<DoorFrame>>& doors) {
    std::vector<Box> boxes;
    walls.each([&](const Wall& wall) { boxes.push_back(wall.box); });
    doors.each([&](const Door& door, const DoorFrame& frame) {
        for (const Box& leaf : frame.leaf) {
            boxes.push_back(turned_about(leaf, frame.hinge, door.angle));
        }
    });
    return boxes;
}

bool in_reach(const Player& player, const dvec3& target) {
    dvec3 way = target - player.position;
    way.y = 0;
    const double distance = glm::length(way);
    return distance < kReach && glm::dot(way, player.facing()) > 0.3 * distance;
}

dvec3 flat_turned(double yaw, double ahead, double aside) {
    const double c = std::cos(yaw), s = std::sin(yaw);
    return {-s * ahead + c * aside, 0, -c * ahead - s * aside};
}

// Where the hand is: held out, but drawn in as far as it takes to keep the lantern out of walls.
dvec3 hand_of(const Player& player, double handle, std::span<const Box> boxes) {
    const dvec3 shoulder = player.eye() - dvec3(0, kHandBelow, 0);
    const dvec3 out = flat_turned(player.yaw, kHandAhead, kHandAside);
    constexpr int kTries = 8;
    // From the body outwards, so that the hand never reaches through a wall.
    dvec3 hand = shoulder;
    for (int i = 1; i <= kTries; ++i) {
        const dvec3 next = shoulder + out * (double(i) / kTries);
        if (overlaps({next - dvec3(0, handle, 0), kLanternRadius, handle}, boxes)) {
            break;
        }
        hand = next;
    }
    return hand;
}

void hang(Lantern& lantern, const LanternShape& shape, const dvec3& hand) {
    const dvec3 velocity = (hand - lantern.hand) / kStep;
    const dvec3 pull = glm::clamp((velocity - lantern.hand_velocity) / kStep, dvec3(-30), dvec3(30));
    lantern.hand = hand;
    lantern.hand_velocity = velocity;
    const glm::dvec2 force = -glm::dvec2(pull.x, pull.z) / 0.3;
    lantern.sway_speed += kStep * (force - kPendulum * lantern.sway - kPendulumDamping * lantern.sway_speed);
    lantern.sway =
        glm::clamp(lantern.sway + kStep * lantern.sway_speed, glm::dvec2(-kMaxSway), glm::dvec2(kMaxSway));
    // Comes to rest for good, so that a still scene is still.
    if (force == glm::dvec2(0) && glm::length(lantern.sway) < 1e-3 &&
        glm::length(lantern.sway_speed) < 1e-2) {
        lantern.sway = lantern.sway_speed = glm::dvec2(0);
    }
    lantern.position = hand - dvec3(lantern.rotation() * vec3(0, static_cast<float>(shape.handle), 0));
}

// Onto the highest thing below the hand, else onto the floor.
void put_down(Lantern& lantern, const Player& player, std::span<const Box> boxes) {
    lantern.carried = false;
    double floor = player.position.y;
    for (const Box& box : boxes) {
        const double top = box.centre.y + box.half.y;
        if (top > floor && top <= lantern.position.y &&
            overlaps({lantern.position - dvec3(0, lantern.position.y - top + 0.01, 0), kLanternRadius, 1},
                     box)) {
            floor = top;
        }
    }
    lantern.position.y = floor;
    lantern.sway = lantern.sway_speed = glm::dvec2(0);
    lantern.hand_velocity = dvec3(0);
}

}  // namespace

dvec3 Player::facing() const {
    return flat_turned(yaw, 1, 0);
}

quat Lantern::rotation() const {
    // It hangs from its upper end: turned about +Z that end stays and the lower one goes to +X, about -X to
    // +Z.
    return glm::angleAxis(static_cast<float>(sway.x), vec3(0, 0, 1)) *
           glm::angleAxis(static_cast<float>(-sway.y), vec3(1, 0, 0)) *
           glm::angleAxis(static_cast<float>(yaw), vec3(0, 1, 0));
}

void count_step(ResMut<Clock> clock) {
    ++clock->step;
}

void intend(Res<PlayerInput> input, Query<Read<Player>> players, ResMut<StepIntent> intent) {
    players.each([&](const Player& player) {
        intent->yaw = input->yaw * kLookUnit;
        intent->pitch = input->pitch * kLookUnit;
        dvec3 walk = flat_turned(player.yaw + intent->yaw, input->forward / 32767.0, input->right / 32767.0);
        const double length = glm::length(walk);
        intent->walk = walk * (Player::kSpeed / std::max(1.0, length));
        intent->pressed = static_cast<std::uint16_t>(input->held & ~player.held);
    });
}

void swing_door(Res<StepIntent> intent, Query<Read<Player>> players,
                Query<Write<Door>, Read<DoorFrame>> doors) {
    players.each([&](const Player& player) {
        doors.each([&](Door& door, const DoorFrame& frame) {
            const dvec3 middle = turned_about({frame.middle}, frame.hinge, door.angle).centre;
            if ((intent->pressed & kUse) && in_reach(player, middle)) {
                door.open = !door.open;
            }
            const double target = door.open ? frame.open_angle : 0;
            if (door.angle == target && door.speed == 0) {
                return;
            }
            const double damping = 2 * std::sqrt(kSpring);  // critical: no overshoot
            door.speed += kStep * (kSpring * (target - door.angle) - damping * door.speed);
            double next = door.angle + kStep * door.speed;
            if (std::abs(next - target) < 1e-3 && std::abs(door.speed) < 1e-2) {
                next = target;
                door.speed = 0;
            }
            for (const Box& leaf : frame.leaf) {
                if (overlaps(player.body(), turned_about(leaf, frame.hinge, next)) &&
                    !overlaps(player.body(), turned_about(leaf, frame.hinge, door.angle))) {
                    next = door.angle;
                    door.speed = 0;
                }
            }
            door.angle = next;
        });
    });
}

void walk(Res<PlayerInput> input, Res<StepIntent> intent, Query<Read<Wall>> walls,
          Query<Read<Door>, Read<DoorFrame>> doors, Query<Write<Player>> players) {
    const std::vector<Box> boxes = obstacles(walls, doors);
    players.each([&](Player& player) {
        player.yaw = std::remainder(player.yaw + intent->yaw, 2 * std::acos(-1.0));
        player.pitch = std::clamp(player.pitch + intent->pitch, -kMaxPitch, kMaxPitch);
        player.velocity += (intent->walk - player.velocity) * (1 - std::exp(-kQuickness * kStep));
        if (intent->walk == dvec3(0) && glm::length(player.velocity) < 1e-2) {
            player.velocity = dvec3(0);
        }
        const dvec3 before = player.position;
        const dvec3 after = slide(player.body(), player.velocity * kStep, boxes);
        player.position = {after.x, before.y, after.z};
        player.velocity = (player.position - before) / kStep;
        player.held = input->held;
    });
}

void carry_lantern(Res<StepIntent> intent, Query<Read<Player>> players, Query<Read<Wall>> walls,
                   Query<Read<Door>, Read<DoorFrame>> doors,
                   Query<Write<Lantern>, Read<LanternShape>> lanterns) {
    const std::vector<Box> boxes = obstacles(walls, doors);
    players.each([&](const Player& player) {
        lanterns.each([&](Lantern& lantern, const LanternShape& shape) {
            const dvec3 hand = hand_of(player, shape.handle, boxes);
            if ((intent->pressed & kLight) && (lantern.carried || in_reach(player, lantern.position))) {
                lantern.lit = !lantern.lit;
            }
            if ((intent->pressed & kCarry) && lantern.carried) {
                put_down(lantern, player, boxes);
            } else if ((intent->pressed & kCarry) && in_reach(player, lantern.position)) {
                lantern.carried = true;
                lantern.hand = hand;
            }
            if (lantern.carried) {
                lantern.yaw = player.yaw;
                hang(lantern, shape, hand);
            }
        });
    });
}

void sense(Res<SensorInput> input, Query<Write<FarRoom>> rooms) {
    rooms.each([&](FarRoom& room) {
        for (const replay::SensorReading& reading : input->readings) {
            room.lux = reading.value;
            room.lit = room.lit || room.lux >= FarRoom::kLit;
        }
    });
}

}  // namespace lanthorn::game
