// A scene with two clips whose poses are known at every moment.
#pragma once

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::support {

inline AnimationClip along(int axis, const char* name) {
    AnimationClip clip;
    clip.name = name;
    clip.duration = 2;
    AnimationChannel& channel = clip.channels.emplace_back();
    channel.times = {0, 2};
    channel.values.resize(6);
    channel.values[static_cast<std::size_t>(3 + axis)] = 2;  // one metre a second
    return clip;
}

// A node with a child; one clip moves it along x, one along y.
inline SceneData sliding_node() {
    SceneData s;
    s.nodes.resize(2);
    s.nodes[1].parent = 0;
    s.nodes[1].local.translation.z = 5;
    s.animations = {along(0, "east"), along(1, "up")};
    return s;
}

}  // namespace lanthorn::support
