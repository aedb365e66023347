// A framebuffer object over textures it does not own.
#pragma once

#include <epoxy/gl.h>

#include <initializer_list>

#include "lanthorn/gpu/texture.h"

namespace lanthorn::gpu {

class Framebuffer {
  public:
    Framebuffer() = default;
    // Attaches level 0 of each texture; array textures are attached whole (layered, gl_Layer chooses).
    // `depth` may be null. Throws std::logic_error when incomplete.
    Framebuffer(std::initializer_list<const Texture*> colours, const Texture* depth);
    // Attaches layer `layer` of array textures (and the whole of plain ones).
    Framebuffer(std::initializer_list<const Texture*> colours, const Texture* depth, int layer);
    ~Framebuffer();
    Framebuffer(Framebuffer&& other) noexcept;
    Framebuffer& operator=(Framebuffer&& other) noexcept;

    GLuint id() const { return id_; }  // GL's name; 0 of a default-constructed one
    explicit operator bool() const { return id_ != 0; }
    // Draws go into it from now on; `viewport` in pixels, its lower left corner at that of the textures.
    void bind(ivec2 viewport) const;

  private:
    void attach(std::initializer_list<const Texture*> colours, const Texture* depth, int layer);

    GLuint id_ = 0;
};

}  // namespace lanthorn::gpu
