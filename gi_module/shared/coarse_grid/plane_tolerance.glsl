// How far points of one surface may be off each other's plane; needs camera.glsl.
#ifndef LANTHORN_COARSE_GRID_PLANE_TOLERANCE_GLSL
#define LANTHORN_COARSE_GRID_PLANE_TOLERANCE_GLSL

#include "same_surface.h"

// Metres, as PointView::tolerance.
float plane_tolerance(float distance) {
    return kPlaneTolerance * 2.0 * length(camera_up) * (camera_orthographic != 0 ? 1.0 : distance);
}

#endif
