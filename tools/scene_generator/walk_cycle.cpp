#include "tools/scene_generator/walk_cycle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lanthorn::scene_generator {

namespace {

constexpr double kStance = 0.6;      // share of the cycle that a foot is on the ground
constexpr double kHeelOff = 0.35;    // share of the cycle after which the heel leaves the ground
constexpr double kSole = 0.13;       // ankle to toes, metres
constexpr double kClearance = 0.05;  // of the foot that swings, metres
constexpr double kStretch = 0.998;   // of a leg that is never quite straight

// Where the ankle is and how the foot is tilted (toes down).
struct Foot {
    double ahead, rise, toes;
};

Foot foot_at(double u, double reach, const Gait& gait) {
    const double behind = -(1 + gait.trail) * reach;
    const double before = (1 - gait.trail) * reach;
    if (u <= kStance) {
        const double heel = std::max(0.0, (u - kHeelOff) / (kStance - kHeelOff));
        const double rise = gait.heel * heel * heel;
        return {before + (behind - before) * u / kStance, rise, std::asin(rise / kSole)};
    }
    const double s = (u - kStance) / (1 - kStance);
    const double left = (1 - s) * (1 - s);
    const double hump = std::sin(std::numbers::pi * s);
    return {behind + (before - behind) * s * s * (3 - 2 * s), gait.heel * left + kClearance * hump,
            std::asin(gait.heel / kSole) * left - 0.2 * hump * s};
}

}  // namespace

WalkPose walk_pose(double phase, double stride, const Legs& legs, const Gait& gait) {
    const double pi = std::numbers::pi;
    WalkPose pose;
    // As high as a stretched leg allows when it is put down.
    const double reach = 0.5 * kStance * stride;
    const double before = (1 - gait.trail) * reach;
    const double longest = kStretch * (legs.thigh + legs.shin);
    const double highest = std::sqrt(longest * longest - before * before) - (legs.hip - legs.ankle);
    pose.lift = highest - gait.bob + gait.bob * std::cos(4 * pi * phase);
    pose.swing = 0.45 * std::cos(2 * pi * phase);
    pose.twist = 0.12 * std::cos(2 * pi * phase);
    for (std::size_t side = 0; side < 2; ++side) {
        const double own = phase + 0.5 * static_cast<double>(side);
        const auto [ahead, rise, toes] = foot_at(own - std::floor(own), reach, gait);
        const double height = legs.ankle + rise;
        const double down = legs.hip + pose.lift - height;
        const double distance = std::min(std::hypot(down, ahead), kStretch * (legs.thigh + legs.shin));
        const double a = legs.thigh, b = legs.shin;
        const double at_hip = std::acos((a * a + distance * distance - b * b) / (2 * a * distance));
        const double at_knee = std::acos((a * a + b * b - distance * distance) / (2 * a * b));
        pose.thigh[side] = -std::atan2(ahead, down) - at_hip;
        pose.shin[side] = pi - at_knee;
        pose.foot[side] = -(pose.thigh[side] + pose.shin[side]) + toes;
    }
    return pose;
}

}  // namespace lanthorn::scene_generator
