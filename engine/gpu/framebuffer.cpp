#include "lanthorn/gpu/framebuffer.h"

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

namespace lanthorn::gpu {

Framebuffer::Framebuffer(std::initializer_list<const Texture*> colours, const Texture* depth) {
    attach(colours, depth, -1);
}

Framebuffer::Framebuffer(std::initializer_list<const Texture*> colours, const Texture* depth, int layer) {
    attach(colours, depth, layer);
}

void Framebuffer::attach(std::initializer_list<const Texture*> colours, const Texture* depth, int layer) {
    glCreateFramebuffers(1, &id_);
    const auto attach_one = [&](GLenum attachment, const Texture& texture) {
        if (layer >= 0 && texture.target() != GL_TEXTURE_2D) {
            glNamedFramebufferTextureLayer(id_, attachment, texture.id(), 0, layer);
        } else {
            glNamedFramebufferTexture(id_, attachment, texture.id(), 0);
        }
    };
    std::array<GLenum, 8> draws{};
    GLsizei count = 0;
    for (const Texture* texture : colours) {
        const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(count);
        attach_one(attachment, *texture);
        draws.at(static_cast<std::size_t>(count++)) = attachment;
    }
    if (depth != nullptr) {
        attach_one(GL_DEPTH_ATTACHMENT, *depth);
    }
    glNamedFramebufferDrawBuffers(id_, count, draws.data());
    const GLenum status = glCheckNamedFramebufferStatus(id_, GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw std::logic_error("framebuffer incomplete: status " + std::to_string(status));
    }
}

Framebuffer::~Framebuffer() {
    if (id_ != 0) {
        glDeleteFramebuffers(1, &id_);
    }
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept : id_(std::exchange(other.id_, 0)) {}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
}

void Framebuffer::bind(ivec2 viewport) const {
    glBindFramebuffer(GL_FRAMEBUFFER, id_);
    glViewport(0, 0, viewport.x, viewport.y);
}

}  // namespace lanthorn::gpu
