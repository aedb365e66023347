// Draws flames that shine in the picture alone: what is lit by them is lit by lights.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/render/strip_data.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/picture_only.h"

namespace lanthorn::render {

class GlowPass {
  public:
    // Over the radiance in `target`, where its depth does not hide them; those that are not finite, or have
    // no width, are left out. `origin`: FrameScene::origin. O(pixels that they cover).
    void draw(std::span<const Glow> glows, const CameraUniforms& camera, const dvec3& origin,
              const gpu::Framebuffer& target, ivec2 size);

  private:
    std::optional<gpu::Program> program_;  // none before there are any
    gpu::GrowingBuffer buffer_;
    std::vector<PictureGlow> shown_;
};

}  // namespace lanthorn::render
