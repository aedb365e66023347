// Draws lines onto a picture.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/render/strip_data.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/growing_buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/camera_uniforms.h"
#include "lanthorn/render/lines.h"

namespace lanthorn::render {

// What of a line lies before the camera, in a picture of `size`; none: nothing does, or an end is not finite.
// In double precision and relative to the camera: a line may pass it at any length, and lie anywhere.
// `origin`: FrameScene::origin. Tested against depth as if it were a pixel's width nearer, so that lines on
// surfaces are seen.
std::optional<PictureLine> in_picture(const Line& line, const CameraUniforms& camera, const dvec3& origin,
                                      ivec2 size);

class LinePass {
  public:
    LinePass();

    // Those that are hidden by what `target`'s depth holds first, those on top over them; in the order given
    // among themselves. O(lines).
    void draw(std::span<const Line> everywhere, std::span<const Line> here, const CameraUniforms& camera,
              const dvec3& origin, const gpu::Framebuffer& target, ivec2 size);

  private:
    gpu::Program program_;
    gpu::GrowingBuffer buffer_;
    std::vector<PictureLine> lines_;
};

}  // namespace lanthorn::render
