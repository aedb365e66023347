#include "engine/render/fullscreen.h"

#include "lanthorn/gpu/context.h"

namespace lanthorn::render {

namespace {

// A vertex array without vertices, kept: as good as any other of the current context.
GLuint no_vertices() {
    static GLuint kept = 0;
    if (kept == 0 || !glIsVertexArray(kept)) {  // another context
        glCreateVertexArrays(1, &kept);
    }
    return kept;
}

}  // namespace

void draw_fullscreen(const gpu::Program& program, const gpu::Framebuffer& target, ivec2 size) {
    target.bind(size);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    program.use();
    bind_no_vertices();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

bool in_compute(PixelStage stage) {
    return stage == PixelStage::compute || (stage == PixelStage::by_device && !gpu::draws_in_software());
}

void compute_fullscreen(const gpu::Program& program, const gpu::Texture& target, ivec2 size) {
    constexpr int kGroup = 8;  // pixel_pass.glsl
    target.bind_image(0, GL_WRITE_ONLY);
    program.use();
    // What came before may still read the target.
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    glDispatchCompute(static_cast<GLuint>((size.x + kGroup - 1) / kGroup),
                      static_cast<GLuint>((size.y + kGroup - 1) / kGroup), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                    GL_TEXTURE_UPDATE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_SHADER_STORAGE_BARRIER_BIT);
}

void bind_no_vertices() {
    glBindVertexArray(no_vertices());
}

}  // namespace lanthorn::render
