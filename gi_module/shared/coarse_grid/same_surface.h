// When two points count as one surface; read by C++ and GLSL.
#ifndef LANTHORN_COARSE_GRID_SAME_SURFACE_H
#define LANTHORN_COARSE_GRID_SAME_SURFACE_H

#ifdef __cplusplus
namespace lanthorn::gi {
#endif

// Off each other's plane by less than this share of the picture's height at their distance ...
const float kPlaneTolerance = 0.004f;
// ... and normals turned by less: a cosine.
const float kLeastTurn = 0.9f;

#ifdef __cplusplus
}  // namespace lanthorn::gi
#endif

#endif
