// Passes that cover every pixel once, with fullscreen.vert.
#pragma once

#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::render {

// Draws `program` over the whole of `target` (`size` pixels), without depth test or blending.
void draw_fullscreen(const gpu::Program& program, const gpu::Framebuffer& target, ivec2 size);

// For programs whose vertices come from elsewhere than vertex buffers.
void bind_no_vertices();

}  // namespace lanthorn::render
