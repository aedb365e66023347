// A picture whose radiance comes from elsewhere (a path tracer, say), shown as the renderer shows its own.
#pragma once

#include <vector>

#include "lanthorn/core/image.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/composite.h"

namespace lanthorn::render {

class RadiancePicture {
  public:
    // `radiance`: nits, three a pixel; `coverage`: the share of each that surfaces cover. Rows from the top.
    RadiancePicture(const std::vector<float>& radiance, const std::vector<float>& coverage, ivec2 size);

    // By itself, as a first frame: display-encoded. Waits for the GPU.
    ImageF display(const RenderSettings& settings);

  private:
    ivec2 size_;
    gpu::Texture depth_;
    Composite composite_;
};

}  // namespace lanthorn::render
