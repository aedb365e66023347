// Figures stand, walk and turn; the hero's body goes where the player goes.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "game/rules/headings.h"
#include "game/rules/systems.h"
#include "lanthorn/core/time_step.h"

namespace lanthorn::game {

namespace {

constexpr double kTakeUp = 0.25;      // of the difference to a new velocity that a step takes up
constexpr double kFullWalk = 0.6;     // metres a second from which on nothing of standing shows
constexpr double kBlend = 0.08;       // of the way from standing to walking, at most, in a step
constexpr double kTurningPace = 0.4;  // metres a second that the feet go at while it turns on the spot
constexpr double kJump = 20;          // metres a second: nobody walks so fast, it has been put there

void measure(Figure& figure, const dvec3& place) {
    dvec3 velocity = (place - figure.place) / kStepSeconds;
    velocity.y = 0;
    if (glm::length(velocity) > kJump) {
        velocity = figure.velocity = dvec3(0);
    }
    figure.place = place;
    figure.velocity += kTakeUp * (velocity - figure.velocity);
    if (velocity == dvec3(0) && glm::length(figure.velocity) < 1e-2) {
        figure.velocity = dvec3(0);
    }
}

}  // namespace

void face_hero(Res<Intent> intent, Query<Read<FollowCamera>> cameras,
               Query<Write<Figure>, Read<Parent>> figures) {
    constexpr double kWalks = 0.3;  // metres a second from which on she turns to where she walks
    constexpr double kLooksAway = 0.9, kLooksThere = 0.05;  // radians
    constexpr std::uint32_t kHandles = kUse | kCarry;
    bool first_person = false;
    cameras.each([&](const FollowCamera& camera) { first_person = camera.first_person; });
    figures.each([&](Figure& hero, const Parent& above) {
        if (above.entity != intent->player) {
            return;
        }
        const double away = std::abs(turn_between(hero.yaw, intent->yaw));
        if (first_person) {
            hero.yaw = intent->yaw;
            hero.turning = false;
        } else if (glm::length(hero.velocity) > kWalks) {
            hero.yaw = turned_towards(hero.yaw, heading_of(hero.velocity), 0.16, 0.13);
            hero.turning = false;
        } else if (away > kLooksAway || (intent->pressed & kHandles) != 0 || hero.turning) {
            hero.yaw = turned_towards(hero.yaw, intent->yaw, 0.12, 0.07);
            hero.turning = away > kLooksThere;
        }
    });
}

void walk_figures(Query<Write<Figure>, Read<WorldTransform>, Mut<LocalTransform>, Read<AnimationSet>,
                        Write<AnimationPlayer>>
                      figures) {
    figures.each([](Figure& figure, const WorldTransform& world, ecs::MutRef<LocalTransform> local,
                    const AnimationSet& set, AnimationPlayer& player) {
        measure(figure, dvec3(world.matrix[3]));
        const double speed = glm::length(figure.velocity);
        const bool backwards = glm::dot(figure.velocity, facing_of(figure.yaw)) < -0.3 * speed;
        figure.pace = figure.turning ? std::max(speed, kTurningPace) : backwards ? -speed : speed;
        const double share = std::min(std::abs(figure.pace) / kFullWalk, 1.0);
        const double wanted = share * share * (3 - 2 * share);
        figure.walking += std::clamp(wanted - figure.walking, -kBlend, kBlend);

        AnimationLayer &idle = player.layers[0], &walk = player.layers[1];
        idle.weight = 1 - figure.walking;
        walk.weight = figure.walking;
        walk.speed = figure.pace * (*set.clips)[walk.clip].duration / figure.stride;
        const quat rotation = quat(about_y(figure.yaw + std::numbers::pi));
        if (local->value.rotation != rotation) {
            local.write().value.rotation = rotation;
        }
    });
}

}  // namespace lanthorn::game
