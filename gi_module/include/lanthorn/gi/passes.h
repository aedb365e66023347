// What the compute passes of every technique begin and end with.
#pragma once

#include "lanthorn/gpu/program.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

// Uses the program and gives it what the camera sees: the uniforms of camera.glsl, `image_size`, and
// `gbuffer_distance` and `gbuffer_normals` on texture units `unit` and the next.
void use_surfaces(const gpu::Program& program, const render::FrameInputs& inputs, GLuint unit = 0);

// Whatever shaders have written so far can be read by shaders, dispatches and the CPU after it.
void wait_for_shaders();

}  // namespace lanthorn::gi
