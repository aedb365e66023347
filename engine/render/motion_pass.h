// How far what moves has come in the picture since the frame before, by pixel.
#pragma once

#include <vector>

#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/gbuffer.h"

namespace lanthorn::render {

class MotionPass {
  public:
    explicit MotionPass(ivec2 size);

    // Draws those of GpuScene::movers() that the G-buffer, drawn with `camera`, has drawn, as they are seen
    // there. `before`: of the frame before, looking through the middles of pixels. False, and nothing is
    // drawn, where nothing has moved. Cost: the triangles of what moves.
    bool draw(const GBuffer& gbuffer, const GpuScene& scene, const CameraUniforms& camera,
              const CameraUniforms& before);

    // RGBA32F: upscale_motion.glsl's motion_from(), a: 1; all 0 where nothing moves by itself.
    const gpu::Texture& motion() const { return motion_; }

  private:
    ivec2 size_;
    gpu::Texture motion_;
    gpu::Framebuffer framebuffer_;
    gpu::Program program_;
    gpu::GrowingBuffer before_;  // mat4 by mover
    std::vector<DrawnInstance> rigid_, bent_;
    std::vector<mat4> transforms_;
};

// The uniforms of upscale_motion.glsl, but for `shift`.
void set_before(const gpu::Program& program, const CameraUniforms& before);

}  // namespace lanthorn::render
