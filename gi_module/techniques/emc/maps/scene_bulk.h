// Where a scene's surfaces are, but for strays.
#pragma once

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// The bounds of the surfaces without what lies far off: triangles that reach beyond 4 times the radius,
// around the middle of all surface, within which 99 % of the area lies. Render space; the scene's own bounds
// where there are no such strays. O(triangles).
Aabb scene_bulk(const FrameScene& scene);

}  // namespace lanthorn::gi
