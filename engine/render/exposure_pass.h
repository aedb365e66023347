// Radiance -> exposure, in the composite's state (expose.comp).
#pragma once

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program_variants.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/composite.h"

namespace lanthorn::render {

class ExposurePass {
  public:
    void measure(const gpu::Texture& radiance, const RenderSettings& settings,
                 const Composite::Metering& metering, const gpu::Buffer& state);

  private:
    gpu::ProgramVariants program_{{"engine/render/expose.comp"}};
};

}  // namespace lanthorn::render
