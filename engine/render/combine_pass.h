// Parts of light -> radiance: the composite's first stage.
#pragma once

#include "lanthorn/gpu/program_variants.h"
#include "lanthorn/render/composite.h"

namespace lanthorn::render {

class CombinePass {
  public:
    struct Inputs {
        const GBuffer& gbuffer;
        const Composite::Parts& parts;
        const SkyTexture& sky;
        const BrdfTable& brdf_table;
        const CameraUniforms& camera;
        const gpu::Buffer& state;  // of CompositeState: values that are not finite are counted there
    };
    struct Target {
        const gpu::Texture& radiance;
        const gpu::Framebuffer& framebuffer;  // draws into it
        ivec2 size;
    };
    void draw(const Inputs& inputs, PixelStage stage, const Target& target);

  private:
    gpu::ProgramVariants fragments_{{"engine/render/fullscreen.vert", "engine/render/combine.frag"}};
    gpu::ProgramVariants compute_{{"engine/render/combine.comp"}};
};

}  // namespace lanthorn::render
