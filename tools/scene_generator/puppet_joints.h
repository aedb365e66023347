// The puppet's skeleton in its bind pose: every joint upright, so that a place says it all.
#pragma once

#include <array>

#include "lanthorn/core/math.h"

namespace lanthorn::scene_generator {

// Parents before children. The figure faces +Z; its left is +X.
enum class PuppetJoint : std::uint16_t {
    hips,
    spine,
    chest,
    neck,
    head,
    arm_l,
    forearm_l,
    hand_l,
    arm_r,
    forearm_r,
    hand_r,
    thigh_l,
    shin_l,
    foot_l,
    thigh_r,
    shin_r,
    foot_r,
    cape_1,
    cape_2,
    cape_3
};

struct PuppetJointPlace {
    const char* name;
    int parent;   // -1: the puppet's own node
    dvec3 place;  // metres, from the ground between the feet
};

inline constexpr std::size_t kPuppetJoints = 20;

inline const std::array<PuppetJointPlace, kPuppetJoints>& puppet_joints() {
    static const std::array<PuppetJointPlace, kPuppetJoints> joints = {{
        {"hips", -1, {0, 0.92, 0}},        {"spine", 0, {0, 1.05, 0}},
        {"chest", 1, {0, 1.22, 0}},        {"neck", 2, {0, 1.45, 0}},
        {"head", 3, {0, 1.52, 0}},         {"arm.l", 2, {0.19, 1.40, 0}},
        {"forearm.l", 5, {0.19, 1.12, 0}}, {"hand.l", 6, {0.19, 0.87, 0}},
        {"arm.r", 2, {-0.19, 1.40, 0}},    {"forearm.r", 8, {-0.19, 1.12, 0}},
        {"hand.r", 9, {-0.19, 0.87, 0}},   {"thigh.l", 0, {0.095, 0.90, 0}},
        {"shin.l", 11, {0.095, 0.49, 0}},  {"foot.l", 12, {0.095, 0.08, 0}},
        {"thigh.r", 0, {-0.095, 0.90, 0}}, {"shin.r", 14, {-0.095, 0.49, 0}},
        {"foot.r", 15, {-0.095, 0.08, 0}}, {"cape.1", 2, {0, 1.40, -0.15}},
        {"cape.2", 17, {0, 1.10, -0.17}},  {"cape.3", 18, {0, 0.80, -0.20}},
    }};
    return joints;
}

inline const dvec3& joint_place(PuppetJoint joint) {
    return puppet_joints()[static_cast<std::size_t>(joint)].place;
}

}  // namespace lanthorn::scene_generator
