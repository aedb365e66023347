#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

void use_surfaces(const gpu::Program& program, const render::FrameInputs& inputs, GLuint unit) {
    program.use();
    inputs.camera.set(program);
    inputs.gbuffer.distance().bind(unit);
    inputs.gbuffer.normals().bind(unit + 1);
    program.set("gbuffer_distance", static_cast<int>(unit));
    program.set("gbuffer_normals", static_cast<int>(unit + 1));
    program.set("image_size", inputs.gbuffer.size());
}

void wait_for_shaders() {
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace lanthorn::gi
