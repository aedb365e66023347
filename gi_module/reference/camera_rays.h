// Pixels to rays, as engine/render/camera.glsl has them.
#pragma once

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::reference {

struct CameraRay {
    vec3 origin{0};      // render space
    vec3 direction{0};   // unit
    float nearest = 0;   // metres along the ray to the near plane
    float farthest = 0;  // to the far plane; infinite for perspective cameras, as the rasteriser has it
};

class CameraRays {
  public:
    CameraRays(const CameraView& view, ivec2 size);

    // Through (x, y) in pixels from the upper left corner of the image; pixel centres are at + 0.5.
    CameraRay ray(float x, float y) const;

  private:
    vec3 position_, right_, up_, forward_;
    vec2 size_;
    bool orthographic_;
    float near_;
    float far_;
};

}  // namespace lanthorn::reference
