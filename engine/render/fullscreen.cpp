#include "lanthorn/render/fullscreen.h"

namespace lanthorn::render {

void draw_fullscreen(const gpu::Program& program, const gpu::Framebuffer& target, ivec2 size) {
    GLuint empty = 0;
    glCreateVertexArrays(1, &empty);
    target.bind(size);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    program.use();
    glBindVertexArray(empty);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDeleteVertexArrays(1, &empty);
}

}  // namespace lanthorn::render
