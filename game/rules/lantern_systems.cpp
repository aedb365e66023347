// Lanterns that are lit, carried about and put down.
#include <algorithm>
#include <cmath>

#include <optional>

#include "game/rules/systems.h"
#include "lanthorn/core/time_step.h"

namespace lanthorn::game {

namespace {

constexpr double kHandAhead = 0.42;  // metres from the eye
constexpr double kHandAside = 0.24;
constexpr double kHandBelow = 0.34;
constexpr double kLanternRadius = 0.1;    // metres, of a lantern
constexpr double kPendulum = 9.81 / 0.3;  // 1 / s^2
constexpr double kPendulumDamping = 4;    // 1 / s
constexpr double kMaxSway = 0.45;         // radians
constexpr double kLiftSeconds = 0.3;      // from where it was taken to the hand

// Where a hand is that nobody sees: held out, but drawn in as far as it takes to keep the lantern out of
// walls.
dvec3 hand_of(const Intent& intent, const physics::Physics& physics, double handle) {
    const dvec3 shoulder = intent.eye - dvec3(0, kHandBelow, 0);
    const dvec3 right = glm::cross(intent.facing, dvec3(0, 1, 0));
    const dvec3 out = intent.facing * kHandAhead + right * kHandAside;
    const dvec3 down(0, 0.5 * handle, 0);
    const double share =
        physics
            .sweep_sphere(shoulder - down, shoulder + out - down, std::max(kLanternRadius, 0.5 * handle),
                          std::span(&intent.player, 1))
            .share;
    return shoulder + share * out;
}

void hang(Lantern& lantern, const dvec3& hand) {
    const dvec3 velocity = (hand - lantern.hand) / kStepSeconds;
    const dvec3 pull = glm::clamp((velocity - lantern.hand_velocity) / kStepSeconds, dvec3(-30), dvec3(30));
    lantern.hand = hand;
    lantern.hand_velocity = velocity;
    const glm::dvec2 force = -glm::dvec2(pull.x, pull.z) / 0.3;
    lantern.sway_speed +=
        kStepSeconds * (force - kPendulum * lantern.sway - kPendulumDamping * lantern.sway_speed);
    lantern.sway = glm::clamp(lantern.sway + kStepSeconds * lantern.sway_speed, glm::dvec2(-kMaxSway),
                              glm::dvec2(kMaxSway));
    // Comes to rest for good, so that a still scene is still.
    if (force == glm::dvec2(0) && glm::length(lantern.sway) < 1e-3 &&
        glm::length(lantern.sway_speed) < 1e-2) {
        lantern.sway = lantern.sway_speed = glm::dvec2(0);
    }
}

// Onto the highest thing below, else onto the floor.
void put_down(Lantern& lantern, Transform& at, const Intent& intent, const physics::Physics& physics) {
    constexpr double kLift = 2 * kLanternRadius;
    const dvec3 from = at.translation + dvec3(0, kLift, 0);
    const dvec3 to(from.x, intent.feet.y - kLift, from.z);
    const physics::Sweep below = physics.sweep_sphere(from, to, kLanternRadius, std::span(&intent.player, 1));
    const double floor = below.met ? glm::mix(from.y, to.y, below.share) - kLanternRadius : intent.feet.y;
    lantern.carried = false;
    lantern.sway = lantern.sway_speed = glm::dvec2(0);
    lantern.hand_velocity = dvec3(0);
    at.translation.y = floor;
    at.rotation = lantern.rotation();
}

constexpr std::uint32_t kLightButtons = kLight | kDimUp | kDimDown | kColour;

// As the buttons say that went down.
void adjust_light(Lantern& lantern, std::uint32_t pressed, Commands& commands) {
    const Light before = lantern.shining();
    const bool was_lit = lantern.lit;
    if ((pressed & kLight) != 0) {
        lantern.lit = !lantern.lit;
    }
    if ((pressed & kDimUp) != 0) {
        lantern.brightness = std::min(lantern.brightness + 1, Lantern::kLevels);
    }
    if ((pressed & kDimDown) != 0) {
        lantern.brightness = std::max(lantern.brightness, 2u) - 1;
    }
    if ((pressed & kColour) != 0) {
        lantern.slide = (lantern.slide + 1) % static_cast<std::uint32_t>(lantern.slides.size() + 1);
    }
    if (!lantern.flame || (was_lit == lantern.lit && (!was_lit || before == lantern.shining()))) {
        return;
    }
    if (lantern.lit) {
        commands.insert(lantern.flame, LightComponent{lantern.shining()});
    } else {
        commands.remove<LightComponent>(lantern.flame);
    }
}

}  // namespace

void carry_lanterns(Res<Intent> intent, Res<SharedPhysics> physics,
                    Query<Mut<Lantern>, Mut<LocalTransform>> lanterns, Commands& commands) {
    lanterns.each([&](ecs::MutRef<Lantern> state, ecs::MutRef<LocalTransform> local) {
        const bool at_hand = state->carried || intent->in_reach(local->value.translation);
        if ((intent->pressed & kLightButtons) != 0 && at_hand) {
            adjust_light(state.write(), intent->pressed, commands);
        }
        if ((intent->pressed & kCarry) == 0 || !at_hand) {
            return;
        }
        Lantern& lantern = state.write();
        if (lantern.carried) {
            put_down(lantern, local.write().value, *intent, **physics);
        } else {
            lantern.carried = true;
            lantern.lift = 0;
        }
    });
}

void hang_lanterns(Res<Intent> intent, Res<SharedPhysics> physics, Query<Read<Hand>> hands,
                   Query<Mut<Lantern>, Mut<LocalTransform>> lanterns, Places places) {
    lanterns.each([&](ecs::MutRef<Lantern> state, ecs::MutRef<LocalTransform> local) {
        if (!state->carried) {
            return;
        }
        std::optional<dvec3> hand;
        hands.each([&](Entity e, const Hand&) { hand = dvec3(place_now(places, e)[3]); });
        if (!hand) {
            hand = hand_of(*intent, **physics, state->handle);
        }
        Lantern& lantern = state.write();
        Transform& at = local.write().value;
        if (lantern.lift == 0) {
            lantern.hand = *hand;
        }
        lantern.yaw = intent->yaw;
        hang(lantern, *hand);
        at.rotation = lantern.rotation();
        const dvec3 hanging = *hand - dvec3(at.rotation * vec3(0, static_cast<float>(lantern.handle), 0));
        // Of the rest of the way, so that it starts from where it is.
        const double before = lantern.lift;
        lantern.lift = std::min(before + kStepSeconds / kLiftSeconds, 1.0);
        at.translation +=
            (before < 1 ? (lantern.lift - before) / (1 - before) : 1) * (hanging - at.translation);
    });
}

}  // namespace lanthorn::game
