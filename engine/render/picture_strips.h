// Rectangles over a picture: four corners each, which a vertex shader places by what a buffer has of it.
#pragma once

#include <cstddef>

#include "lanthorn/core/math.h"
#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::render {

// As long as it lives, `program` draws into `target`, over what is there; depth is tested and stays as it is.
class PictureStrips {
  public:
    // Whether the shader's colours have been multiplied with the share that they cover.
    enum class Alpha { straight, premultiplied };

    PictureStrips(const gpu::Program& program, const gpu::Framebuffer& target, ivec2 size, Alpha alpha);
    ~PictureStrips();
    PictureStrips(const PictureStrips&) = delete;
    PictureStrips& operator=(const PictureStrips&) = delete;

    // So many. `hidden`: by what is nearer to the camera. Whoever draws names the first to the shader.
    void draw(std::size_t count, bool hidden) const;
};

}  // namespace lanthorn::render
