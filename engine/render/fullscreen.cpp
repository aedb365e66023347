#include "engine/render/fullscreen.h"

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

void bind_no_vertices() {
    glBindVertexArray(no_vertices());
}

}  // namespace lanthorn::render
