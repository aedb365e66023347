// The puppet: a skinned figure with a morphing face, a subdivided cape and a lantern, and its walk in a
// circle.
#pragma once

#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/puppet_joints.h"

namespace lanthorn::scene_generator {

// What all puppets of a scene share: indices of meshes.
struct PuppetMeshes {
    std::uint32_t body, cape, head, eyes, lantern;
};
// What it wears, linear reflectances; by itself it is pale, as one that is seen by light from far away is.
struct PuppetDress {
    vec3 tunic{0.62f, 0.6f, 0.56f}, cape{0.68f, 0.09f, 0.07f}, skin{0.74f, 0.52f, 0.4f};
};
PuppetMeshes add_puppet_meshes(Builder& b, const PuppetDress& dress = {});

// One round on a circle, starting at `angle` (radians about +Y, from +Z) and walking to the figure's left.
struct PuppetWalk {
    dvec3 centre{0};
    double radius = 1.25;  // metres
    double angle = 0;      // radians
    double seconds = 10;   // of a round
    int cycles = 10;       // two steps each, in a round
};

using PuppetNodes = std::array<std::uint32_t, kPuppetJoints>;
// The joints of a figure whose feet are at `parent`, named NAME.JOINT, and their skin, the scene's last.
PuppetNodes add_puppet_joints(Builder& b, const std::string& name, std::uint32_t parent);
// A mesh that the scene's last skin poses.
void add_skinned(Builder& b, const std::string& name, std::uint32_t mesh);

// Adds a puppet and its channels to `clip`, which then lasts for the walk's seconds. Returns its hook's node:
// what hangs from the left hand.
std::uint32_t add_puppet(Builder& b, const std::string& name, const PuppetMeshes& meshes,
                         const PuppetWalk& walk, AnimationClip& clip);

}  // namespace lanthorn::scene_generator
