#include "game/tour.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::game {

Tour::Tour(const Level& level) : has_door_(level.door.has_value()) {
    const dvec3 up(0, Player::kEye, 0);
    if (!level.door) {
        for (int i = 1; i <= 8; ++i) {
            const double a = level.start_yaw + i * 0.25 * 3.14159265358979;
            legs_.push_back({kSteps * static_cast<std::uint64_t>(i) / 8, level.start,
                             level.start + up + dvec3(-std::sin(a), 0, -std::cos(a))});
        }
        return;
    }
    dvec3 doorway = level.door->hinge + level.door->middle;
    doorway.y = level.start.y;
    const dvec3 along = glm::normalize(dvec3(level.door->middle.x, 0, level.door->middle.z));
    dvec3 through(along.z, 0, -along.x);  // level, across the leaf
    if (glm::dot(through, doorway - level.start) < 0) {
        through = -through;
    }
    const dvec3 before = doorway - 1.2 * through;
    const dvec3 inside = doorway + 1.5 * through;
    const dvec3 ahead = doorway + 4.0 * through + dvec3(0, 1.2, 0);
    legs_ = {{40, level.start, ahead},
             {kDoorStep + 150, before, ahead},
             {kDoorStep + 260, inside, ahead},
             {kDoorStep + 340, inside, inside + 2.0 * along + through + dvec3(0, 1.0, 0)},
             {kSteps, inside, inside - 2.0 * along + through + dvec3(0, 1.0, 0)}};
}

PlayerInput Tour::next(const View& view, std::uint64_t step) const {
    const Leg* leg = &legs_.back();
    for (const Leg& l : legs_) {
        if (step < l.until) {
            leg = &l;
            break;
        }
    }
    PlayerInput input;
    // Turns towards the target by a share of the way a step, at most 0.04 radians.
    const dvec3 to = leg->target - view.eye;
    const double yaw = std::atan2(-to.x, -to.z), pitch = std::atan2(to.y, std::hypot(to.x, to.z));
    const auto turn = [](double difference) { return look(std::clamp(0.06 * difference, -0.04, 0.04)); };
    input.yaw = turn(std::remainder(yaw - view.yaw, 2 * 3.14159265358979323846));
    input.pitch = turn(pitch - view.pitch);

    // Walks towards the goal, slower when near, whichever way it looks.
    dvec3 way = leg->goal - view.eye;
    way.y = 0;
    const double distance = glm::length(way);
    if (distance > 0.03) {
        const dvec3 wish = way * (std::min(0.6, 2 * distance) / distance);
        const double c = std::cos(view.yaw), s = std::sin(view.yaw);
        input.forward = axis(-s * wish.x - c * wish.z);
        input.right = axis(c * wish.x - s * wish.z);
    }
    if (has_door_ && step == kDoorStep) {
        input.held = kUse;
    }
    return input;
}

}  // namespace lanthorn::game
