// What plays on an entity with an AnimationSet: layers of clips, their blending, root motion.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/animation/playback.h"
#include "lanthorn/core/math.h"
#include "lanthorn/scene/components.h"

namespace lanthorn {

// One clip that plays. What is not a number counts as 0, and so does a negative weight.
struct AnimationLayer {
    std::uint32_t clip = 0;  // into AnimationSet::clips; a layer of a clip that is not there does nothing
    double time = 0;         // seconds since the clip's start, moved on by speed; see clip_moment()
    double speed = 1;        // seconds of the clip a second; negative: backwards
    LoopMode loop = LoopMode::loop;
    double weight = 1;  // 0 or more

    double fade_to = 1;         // the weight at the end of a fade
    double fade_seconds = 0;    // until then; 0: no fade
    bool leaves_after = false;  // the layer is removed when its fade ends

    std::vector<std::uint32_t> hints;  // the animator's, by channel: the key it found last
};

// The movement of one node, taken from the clips so that a character can be moved by it (its collision shape,
// say) instead of walking away from its entity.
//
// delta: what moves the node's parent so that the parent, with the node at its place of the clip's start,
// does what the node did: parent = parent * delta, each step. Scale does not matter.
struct RootMotion {
    std::uint32_t node = kNone;  // into AnimationSet::nodes; kNone: no root motion
    bool rotation = true;        // turns are part of the motion
    bool vertical = false;       // so is +Y of the parent's space
    bool remove = true;          // the pose goes without the motion

    // Written each step.
    dvec3 translation{0};
    quat turn{1, 0, 0, 0};
};

// What the animator keeps about one player; nothing to be set from outside.
struct PlayerBinding {
    // A property that some clip moves.
    struct Target {
        std::uint32_t node;  // into AnimationSet::nodes
        AnimationPath path;
        std::uint32_t width;
        std::uint32_t first;  // into rest and pose
        bool moves = false;   // some layer's clip moves it in this step
        bool owned = false;   // it was written in the step before
        double weight = 0;    // of the layers that move it
    };
    std::shared_ptr<const std::vector<AnimationClip>> clips;
    std::vector<ecs::Entity> nodes;
    std::vector<Target> targets;                         // by node, then path
    std::vector<std::vector<std::uint32_t>> targets_of;  // by clip and channel
    std::vector<double> rest, pose;
    std::vector<double> scratch;  // the widest value
};

// The component. Layers are blended by weight: weights whose sum is above 1 are divided by it; what is
// missing to 1, and what a layer's clip does not move, is the rest pose: what the entities had when the
// player was first animated. Rotations are blended as normalised sums on one hemisphere. Without layers
// nothing is written.
struct AnimationPlayer {
    std::vector<AnimationLayer> layers;
    RootMotion root;
    bool by_clock =
        false;  // the first layer's time is the clock's: it is at any moment what a film of it would be
    PlayerBinding binding;
};

// A file's word on which of its clips plays where nobody asks for one: the component, on any node of a scene.
// The first one counts.
struct StartClip {
    std::string clip;  // by its name; "none": nothing plays; empty: as if there were no such component
};

// The first clip of that name.
std::optional<std::uint32_t> find_clip(const AnimationSet& set, std::string_view name);

// Plays `clip` alone from its start (from its end if `speed` is negative and it plays once). The reference
// lives until layers are added or removed.
AnimationLayer& play(AnimationPlayer& player, const AnimationSet& set, std::uint32_t clip,
                     LoopMode loop = LoopMode::loop, double speed = 1);

// The same, but what plays now fades out in `seconds` (0 or less: at once) while the clip fades in, both
// linearly. A layer that plays the clip already goes on from where it is.
AnimationLayer& cross_fade(AnimationPlayer& player, const AnimationSet& set, std::uint32_t clip,
                           double seconds, LoopMode loop = LoopMode::loop, double speed = 1);

// Whether a layer that plays once has come to its end.
bool finished(const AnimationLayer& layer, const AnimationSet& set);

}  // namespace lanthorn
