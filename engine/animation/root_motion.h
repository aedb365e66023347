// How far a clip carries a node in one step.
#pragma once

#include "lanthorn/animation/animation_player.h"

namespace lanthorn {

// A rotation, then a translation.
struct RigidMotion {
    dvec3 translation{0};
    glm::dquat turn{1, 0, 0, 0};
};

// RootMotion::translation and turn for one layer that goes from `from` to `to` (values of
// AnimationLayer::time). `rest` is the node's rest pose, for what the clip does not move. Whole rounds of a
// loop count. O(log keys + log rounds).
RigidMotion root_motion(const AnimationClip& clip, const RootMotion& root, const RigidMotion& rest,
                        LoopMode loop, double from, double to);

// What the pose has of the node without the motion at `time` seconds of the clip.
RigidMotion without_motion(const AnimationClip& clip, const RootMotion& root, const RigidMotion& rest,
                           double time);

}  // namespace lanthorn
