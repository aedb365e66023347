#include "engine/render/picture_strips.h"

#include "engine/render/fullscreen.h"

namespace lanthorn::render {

PictureStrips::PictureStrips(const gpu::Program& program, const gpu::Framebuffer& target, ivec2 size,
                             Alpha alpha) {
    target.bind(size);
    program.use();
    bind_no_vertices();
    glEnable(GL_BLEND);
    glBlendFuncSeparate(alpha == Alpha::straight ? GL_SRC_ALPHA : GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO,
                        GL_ONE);
    glDepthMask(GL_FALSE);
    glDisable(GL_CULL_FACE);
}

PictureStrips::~PictureStrips() {
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void PictureStrips::draw(std::size_t count, bool hidden) const {
    if (hidden) {
        glEnable(GL_DEPTH_TEST);
    } else {
        glDisable(GL_DEPTH_TEST);
    }
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count));
}

}  // namespace lanthorn::render
