#include "tests/gpu/gi/gl_objects.h"

#include <epoxy/gl.h>

#include "engine/gpu/memory.h"

namespace lanthorn::gi::test {

GlObjects gl_objects() {
    constexpr GLuint kNames = 1 << 14;  // many more than are in use; those of deleted objects are given again
    GlObjects all;
    for (GLuint name = 1; name < kNames; ++name) {
        all.buffers += glIsBuffer(name) != GL_FALSE ? 1 : 0;
        all.textures += glIsTexture(name) != GL_FALSE ? 1 : 0;
        all.framebuffers += glIsFramebuffer(name) != GL_FALSE ? 1 : 0;
        all.programs += glIsProgram(name) != GL_FALSE ? 1 : 0;
    }
    all.bytes = gpu::allocated_bytes();
    return all;
}

std::ostream& operator<<(std::ostream& out, const GlObjects& objects) {
    return out << objects.buffers << " buffers, " << objects.textures << " textures, " << objects.framebuffers
               << " framebuffers, " << objects.programs << " programs, " << objects.bytes << " bytes";
}

}  // namespace lanthorn::gi::test
