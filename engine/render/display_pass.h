// Exposed radiance -> the picture as it is shown: tone map and sRGB (display_pixel.glsl).
#pragma once

#include "lanthorn/gpu/program_variants.h"
#include "lanthorn/render/composite.h"

namespace lanthorn::render {

class DisplayPass {
  public:
    struct Inputs {
        const gpu::Texture& radiance;
        const Composite::DisplayInputs& over;
        const gpu::Buffer& state;  // of CompositeState: the exposure, and what is around
    };
    struct Target {
        const gpu::Texture& final;
        const gpu::Framebuffer& framebuffer;  // draws into it
        ivec2 size;
    };
    void draw(const Inputs& inputs, const RenderSettings& settings, const Target& target);

  private:
    gpu::ProgramVariants fragments_{{"engine/render/fullscreen.vert", "engine/render/display.frag"}};
    gpu::ProgramVariants compute_{{"engine/render/display.comp"}};
};

}  // namespace lanthorn::render
