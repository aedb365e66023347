// The steps of a player's frame: bind to a scene's clips, move the layers on, blend their pose.
#pragma once

#include "lanthorn/animation/animator.h"

namespace lanthorn {

// Makes `player.binding` fit the set; nothing to do while clips and entities are those of the last time. What
// the entities have now becomes the rest pose; entities that are not there have none that shows. Allocates
// only when it has something to do.
void bind(AnimationPlayer& player, const AnimationSet& set, const Animator::Poses& poses);

// Moves times and fades on by `seconds`, removes layers that have faded out, and writes the root motion.
void advance(AnimationPlayer& player, double seconds);

// Writes the blended value of every target that some layer moves to binding.pose, rest values to those that
// were `owned` and are no longer moved, and sets `moves`.
void blend(AnimationPlayer& player);

}  // namespace lanthorn
