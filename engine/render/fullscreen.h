// Passes that cover every pixel once, with fullscreen.vert.
#pragma once

#include "lanthorn/gpu/framebuffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/render_settings.h"

namespace lanthorn::render {

// Draws `program` over the whole of `target` (`size` pixels), without depth test or blending.
void draw_fullscreen(const gpu::Program& program, const gpu::Framebuffer& target, ivec2 size);

// Whether a pass over all pixels is a compute shader: few units of a data centre's GPU rasterise, and a
// software rasteriser is at its best with fragments.
bool in_compute(PixelStage stage);

// The same by a compute shader that writes `target` (pixel_pass.glsl); what reads or draws on it later needs
// no barrier.
void compute_fullscreen(const gpu::Program& program, const gpu::Texture& target, ivec2 size);

// For programs whose vertices come from elsewhere than vertex buffers.
void bind_no_vertices();

}  // namespace lanthorn::render
