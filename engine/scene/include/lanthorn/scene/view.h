// From cameras to views.
#pragma once

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

// The view of a camera whose node has that world transform, in the render space of `origin`. The node's scale
// and shear are ignored. Where a transform has no direction left (a zero scale), the camera looks along -Z.
CameraView camera_view(const Camera& camera, const dmat4& world, const dvec3& origin);

// A perspective view that shows all of `bounds` (render space) in an image at least as wide as high: from +Z,
// slightly above, looking at the centre, which they fill. Empty or non-finite bounds are taken as a cube of 2
// m around 0.
CameraView frame_all(const Aabb& bounds);
// The same of all that is in a scene, without floors that reach far beyond what stands on them. O(instances).
CameraView frame_all(const FrameScene& scene);

// The rotation in a transform as an orthonormal, right-handed basis: column 2 keeps its direction, column 1
// as far as that allows. False if column 2 (or all else) has no length or is not finite.
bool orthonormal_basis(const dmat4& m, glm::dmat3& basis);

}  // namespace lanthorn
