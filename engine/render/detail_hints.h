// Who looks at the scene, for subdivision surfaces that are refined as finely as anyone can tell.
#pragma once

#include "lanthorn/deformation/detail.h"
#include "lanthorn/render/light_maps.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::render {

// A cube map's texels to the radian, on average over a face of `resolution` texels a side.
double cube_samples_per_radian(int resolution);

// Adds a camera whose image is `height` pixels high. `origin`: world position of the view's render space.
void add_camera(DetailHints& hints, const CameraView& view, const dvec3& origin, int height);

// Adds the centres of the lights' maps as they were last brought up to date.
void add_light_maps(DetailHints& hints, const LightMaps& maps, const dvec3& origin);

}  // namespace lanthorn::render
