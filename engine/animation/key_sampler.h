// The value of a channel at a time (glTF 2.0, 3.11 and appendix C).
#pragma once

#include <cstdint>
#include <span>

#include "lanthorn/scene/animation_clip.h"

namespace lanthorn {

// Writes the channel's value at `time` (seconds, finite) to `value`, which has channel.width numbers. Before
// the first key and after the last the value is theirs. Rotations come out as unit quaternions x y z w:
// LINEAR goes the shorter way round (appendix C.4), CUBICSPLINE is normalised after (C.5).
//
// `hint` is the key found last for this channel, any number at first; it only saves time. Cost: O(1) for a
// time at or right after the hint's, else O(log keys). Allocates nothing; the same bits whatever the hint.
void sample(const AnimationChannel& channel, double time, std::uint32_t& hint, std::span<double> value);

}  // namespace lanthorn
