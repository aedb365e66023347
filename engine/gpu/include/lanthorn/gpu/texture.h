// A GL texture object with immutable storage.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::gpu {

class Texture {
  public:
    Texture() = default;
    // Storage of `size` pixels (x, y, layers; layers is 6 * maps for cube arrays, 6 for cubes) with `levels`
    // mip levels. Filtering starts as nearest, wrapping as clamp-to-edge.
    Texture(GLenum target, GLenum internal_format, ivec3 size, int levels = 1);
    // Of `size` pixels, with `levels` mip levels that nothing fills yet.
    static Texture make_2d(GLenum internal_format, ivec2 size, int levels = 1) {
        return {GL_TEXTURE_2D, internal_format, {size, 1}, levels};
    }
    // Of `layers` layers of `size` pixels each.
    static Texture make_2d_array(GLenum internal_format, ivec2 size, int layers, int levels = 1) {
        return {GL_TEXTURE_2D_ARRAY, internal_format, {size, layers}, levels};
    }
    ~Texture();
    Texture(Texture&& other) noexcept;
    Texture& operator=(Texture&& other) noexcept;

    GLuint id() const { return id_; }                   // GL's name; 0 of a default-constructed one
    GLenum target() const { return target_; }           // GL_TEXTURE_2D, ...
    GLenum internal_format() const { return format_; }  // sized: GL_RGBA16F, ...
    ivec3 size() const { return size_; }                // of level 0: x, y, layers
    std::size_t bytes() const { return bytes_; }        // of all levels, as stored
    explicit operator bool() const { return id_ != 0; }

    // GL's filters, GL_NEAREST or GL_LINEAR for `mag`; those of `min` that name mip levels need them filled.
    void set_filter(GLenum min, GLenum mag);
    // GL_REPEAT, GL_CLAMP_TO_EDGE or GL_MIRRORED_REPEAT, of all axes.
    void set_wrap(GLenum wrap);
    void set_depth_compare(bool on);                                // sampler*Shadow look-ups with GL_LEQUAL
    void bind(GLuint unit) const { glBindTextureUnit(unit, id_); }  // for samplers of that unit
    // Binds level `level`, all layers, as an image.
    void bind_image(GLuint unit, GLenum access, int level = 0) const {
        glBindImageTexture(unit, id_, level, GL_TRUE, 0, access, format_);
    }
    // Every texel of a level becomes `value`; not for formats of integers.
    void clear(const vec4& value, int level = 0);
    // Waits for the GPU: whole level as floats of `channels` channels, rows from the bottom as GL has them,
    // layer by layer. Colours of sRGB formats come back linear.
    std::vector<float> read_floats(int channels, int level = 0) const;

  private:
    GLuint id_ = 0;
    GLenum target_ = GL_TEXTURE_2D;
    GLenum format_ = GL_RGBA8;
    ivec3 size_{0};
    std::size_t bytes_ = 0;
};

// Bytes of one texel of the formats we use; asserts on others.
std::size_t texel_bytes(GLenum internal_format);

}  // namespace lanthorn::gpu
