// Where a thing is taken by a hand.
#pragma once

#include "lanthorn/core/math.h"

namespace lanthorn::edit_window {

// Whether the origin of a thing was put where it is for the thing's sake: at the middle or at a side of its
// bounds, along each axis. An origin elsewhere is only where the level's was, and says nothing of the thing.
// Both of the same frame; true for empty bounds.
bool origin_is_meant(const Aabb& bounds, const vec3& origin);

}  // namespace lanthorn::edit_window
