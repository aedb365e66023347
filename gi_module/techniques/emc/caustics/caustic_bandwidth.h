// How wide the splats of caustic photons are: by how densely photons have landed around each (Jensen 1996's
// nearest neighbours; Yao et al. 2010, sec. 6: h = C0 / sqrt(density)). Pure functions, no GL.
#pragma once

#include <span>

#include "gi_module/shared/rays/photon_hit.h"

namespace lanthorn::gi {

// Sets each hit's radius to C0 / sqrt(n), n: photons a square metre around it, by the distance to some of its
// nearest neighbours on surfaces that face alike; at most `widest` metres. On an even patch a splat holds
// pi C0^2 photons, up to a third more: not all of the
// nearest are found. Deterministic. O(hits log hits).
void set_bandwidth(std::span<PhotonHit> hits, float c0, float widest);

}  // namespace lanthorn::gi
