// The hand that holds a lantern out, and draws it in where a wall is in the way.
#include <algorithm>
#include <cmath>

#include "game/rules/headings.h"
#include "game/rules/systems.h"
#include "lanthorn/core/time_step.h"

namespace lanthorn::game {

namespace {

constexpr double kRaise = 3.5;     // of its way to the lantern, a second
constexpr double kStretch = 2;     // of the way out, a second, once there is room again
constexpr double kLantern = 0.16;  // metres: a ball that a lantern fits into
constexpr double kHangs = 0.16;    // metres that its middle is below the hand
constexpr double kCloseShare =
    0.4;  // of the way from her axis to where it is held out, when it is held close

// How far out the hand can be, 0 to 1.
double room_for(const Hand& hand, const dvec3& feet, double yaw, const physics::Physics& physics,
                Entity player) {
    const dvec3 ahead = facing_of(yaw), right = glm::cross(ahead, dvec3(0, 1, 0));
    const dvec3 axis = feet + dvec3(0, hand.out.y - kHangs, 0);
    const dvec3 out = axis + ahead * hand.out.z - right * hand.out.x;
    const double share = physics.sweep_sphere(axis, out, kLantern, std::span(&player, 1)).share;
    return std::clamp((share - kCloseShare) / (1 - kCloseShare), 0.0, 1.0);
}

}  // namespace

void hold_out(Res<Intent> intent, Res<SharedPhysics> physics, Query<Read<Lantern>> lanterns,
              ecs::Lookup<Read<Figure>> figures,
              Query<Write<Hand>, Read<AnimationSet>, Write<AnimationPlayer>> hands) {
    bool carries = false;
    lanterns.each([&](const Lantern& lantern) { carries = carries || lantern.carried; });
    hands.each([&](Hand& hand, const AnimationSet& set, AnimationPlayer& player) {
        const Figure* figure = figures.try_get<Figure>(hand.figure);
        if (figure == nullptr) {
            return;
        }
        const double raise = kRaise * kStepSeconds;
        hand.carrying = std::clamp(hand.carrying + (carries ? raise : -raise), 0.0, 1.0);
        if (hand.carrying > 0) {
            const double room = room_for(hand, intent->feet, figure->yaw, **physics, intent->player);
            hand.room = std::min(room, hand.room + kStretch * kStepSeconds);
        }
        const double share = hand.carrying * hand.carrying * (3 - 2 * hand.carrying);
        AnimationLayer &idle = player.layers[0], &walk = player.layers[1];
        idle.weight = (1 - share) * (1 - figure->walking);
        walk.weight = (1 - share) * figure->walking;
        player.layers[2].weight = share * hand.room;
        player.layers[3].weight = share * (1 - hand.room);
        walk.speed = figure->pace * (*set.clips)[walk.clip].duration / figure->stride;
        // The hand that carries keeps some of the walk's rise and fall.
        player.layers[2].speed = player.layers[3].speed = walk.speed;
    });
}

}  // namespace lanthorn::game
