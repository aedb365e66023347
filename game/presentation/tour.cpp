#include "game/presentation/tour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "game/rules/actions.h"
#include "game/rules/components.h"
#include "lanthorn/core/time_step.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::game {

namespace {

using std::numbers::pi;

template <class T>
ecs::Entity first_with(const ecs::World& world) {
    const std::vector<ecs::Entity> found = world.query<ecs::With<T>>().entities();
    return found.empty() ? ecs::kNullEntity : *std::ranges::min_element(found);
}

dvec3 place_of(const ecs::World& world, ecs::Entity e) {
    return dvec3(world.get<WorldTransform>(e).matrix[3]);
}

// The middle of a closed door's leaf: its mesh is a box from the hinge along +Z of its node.
dvec3 doorway_of(const ecs::World& world, ecs::Entity door) {
    return dvec3(world.get<WorldTransform>(door).matrix * dvec4(0, 1, 0.5, 1));
}

}  // namespace

Tour::Tour(const ecs::World& world) {
    const LevelInfo info = level_info(world);
    if (info.tour.empty()) {
        make_up(world);
    } else {
        follow(info.tour);
    }
}

void Tour::follow(const std::vector<Leg>& legs) {
    double seconds = 0;
    for (const Leg& leg : legs) {
        seconds += leg.seconds;
        legs_.push_back({static_cast<std::uint64_t>(std::llround(seconds / kStepSeconds)), leg.go, leg.look,
                         button_of(leg.deed), leg.hold});
    }
}

void Tour::make_up(const ecs::World& world) {
    const dvec3 start = place_of(world, first_with<Player>(world));
    const dvec3 eye = place_of(world, first_with<Eyes>(world));
    const ecs::Entity door = first_with<Door>(world);
    const ecs::Entity lantern = first_with<Lantern>(world);
    if (!door) {
        const double yaw = world.get<Eyes>(first_with<Eyes>(world)).yaw;
        for (int i = 1; i <= 8; ++i) {
            const double a = yaw + i * 0.25 * pi;
            legs_.push_back({kSteps * static_cast<std::uint64_t>(i) / 8, start,
                             eye + dvec3(-std::sin(a), 0, -std::cos(a))});
        }
        return;
    }
    dvec3 doorway = doorway_of(world, door);
    doorway.y = start.y;
    const dvec3 along = glm::normalize(dvec3(world.get<WorldTransform>(door).matrix[2]));
    dvec3 through(along.z, 0, -along.x);  // level, across the leaf
    if (glm::dot(through, doorway - start) < 0) {
        through = -through;
    }
    const auto beyond = [&](double across, double aside, double height) {
        return doorway + across * through + aside * along + dvec3(0, height, 0);
    };
    if (lantern) {
        const dvec3 at = place_of(world, lantern);
        dvec3 way = at - start;
        way.y = 0;
        const dvec3 beside = start + way * std::max(0.0, 1 - 1.3 / glm::length(way));
        legs_.push_back({kLanternStep + 1, beside, at, kCarry});
        legs_.push_back({kLanternStep + 20, beside, at});
    }
    legs_.push_back({kDoorStep - 60, beyond(-1.2, 0, 0), beyond(0, 0, 1.1)});
    legs_.push_back({kDoorStep + 1, beyond(-1.2, 0, 0), beyond(4, 0, 1.2), kUse});
    legs_.push_back({kDoorStep + 120, beyond(-1.2, 0, 0), beyond(4, 0, 1.2)});
    legs_.push_back({kDoorStep + 240, beyond(1.4, 0, 0), beyond(4, 0.6, 1.0)});
    legs_.push_back({kDoorStep + 380, beyond(1.8, 0.4, 0), beyond(3, -2.4, 0.5)});
    legs_.push_back({kSteps, beyond(2.0, -0.4, 0), beyond(2.9, 2.4, 0.6)});
}

PlayerInput Tour::next(const ecs::World& world, std::uint64_t step) const {
    const Stage* leg = &legs_.back();
    for (const Stage& l : legs_) {
        if (step < l.until) {
            leg = &l;
            break;
        }
    }
    const ecs::Entity eyes = first_with<Eyes>(world);
    const dvec3 eye = place_of(world, eyes);
    const Eyes& look_now = world.get<Eyes>(eyes);
    PlayerInput input;
    // Turns towards the target by a share of the way a step, at most 0.04 radians.
    const dvec3 to = leg->target - eye;
    const double yaw = std::atan2(-to.x, -to.z), pitch = std::atan2(to.y, std::hypot(to.x, to.z));
    const auto turn = [](double difference) {
        return input::turn_units(std::clamp(0.06 * difference, -0.04, 0.04));
    };
    input.yaw = turn(std::remainder(yaw - look_now.yaw, 2 * pi));
    input.pitch = turn(pitch - look_now.pitch);

    // Walks towards the goal, slower when near, whichever way it looks.
    dvec3 way = leg->goal - eye;
    way.y = 0;
    const double distance = glm::length(way);
    if (distance > 0.03) {
        const dvec3 wish = way * (std::min(0.6, 2 * distance) / distance);
        const dvec3 facing = look_now.facing();
        input.forward = axis(glm::dot(wish, facing));
        input.right = axis(glm::dot(wish, glm::cross(facing, dvec3(0, 1, 0))));
    }
    if (leg->hold || step + 1 == leg->until) {
        input.held = leg->held;
    }
    return input;
}

}  // namespace lanthorn::game
