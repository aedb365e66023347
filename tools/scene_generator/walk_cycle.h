// How a figure walks: joint angles as a function of the step.
#pragma once

#include <array>

namespace lanthorn::scene_generator {

// The figure faces +Z and hangs straight down at angle 0; all angles are about +X, radians (negative:
// forward). Index 0 is the left side (+X), 1 the right.
struct WalkPose {
    double lift = 0;  // of the hips, metres; negative: down
    std::array<double, 2> thigh{}, shin{}, foot{};
    double swing = 0;  // of the arms: positive is left arm back
    double twist = 0;  // of hips against chest, about +Y
};

struct Legs {
    double thigh = 0.41, shin = 0.41;  // lengths, metres
    double hip = 0.9;                  // height of the hip joint, standing
    double ankle = 0.08;               // height of the ankle on the ground
};

// What gives a walk its character.
struct Gait {
    double trail = 0.32;  // how much further a foot is behind the hips than before them, of half its way
    double heel = 0.06;   // how high the heel rises before the foot leaves the ground, metres
    double bob = 0.01;    // half of the hips' rise and fall, metres
};

// The pose at `phase` of a walk cycle (0..1, two steps) that covers `stride` metres. A foot is on the ground
// for 0.6 of the cycle and moves back as fast as the figure goes forward, so that it stays where it is.
WalkPose walk_pose(double phase, double stride, const Legs& legs, const Gait& gait = {});

}  // namespace lanthorn::scene_generator
