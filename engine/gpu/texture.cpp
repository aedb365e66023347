#include "lanthorn/gpu/texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "engine/gpu/memory.h"

namespace lanthorn::gpu {

std::size_t texel_bytes(GLenum internal_format) {
    switch (internal_format) {
        case GL_R8:
        case GL_R8UI:
            return 1;
        case GL_RG8:
        case GL_R16F:
            return 2;
        case GL_RGBA8:
        case GL_SRGB8_ALPHA8:
        case GL_RG16F:
        case GL_RG16_SNORM:
        case GL_R32F:
        case GL_R32UI:
        case GL_R32I:
        case GL_RGB10_A2:
        case GL_R11F_G11F_B10F:
        case GL_RGB9_E5:
        case GL_DEPTH_COMPONENT24:
        case GL_DEPTH_COMPONENT32F:
            return 4;
        case GL_RGBA16:
        case GL_RGBA16F:
        case GL_RGBA16_SNORM:
        case GL_RG32F:
        case GL_RG32UI:
            return 8;
        case GL_RGBA32F:
        case GL_RGBA32UI:
            return 16;
        default:
            assert(!"texel_bytes: format not listed");
            return 16;
    }
}

Texture::Texture(GLenum target, GLenum internal_format, ivec3 size, int levels)
    : target_(target), format_(internal_format), size_(size) {
    assert(size.x > 0 && size.y > 0 && size.z > 0 && levels > 0);
    glCreateTextures(target, 1, &id_);
    if (target == GL_TEXTURE_2D || target == GL_TEXTURE_CUBE_MAP) {
        glTextureStorage2D(id_, levels, internal_format, size.x, size.y);
    } else {
        glTextureStorage3D(id_, levels, internal_format, size.x, size.y, size.z);
    }
    for (int level = 0; level < levels; ++level) {
        bytes_ += texel_bytes(internal_format) * static_cast<std::size_t>(std::max(size.x >> level, 1)) *
                  static_cast<std::size_t>(std::max(size.y >> level, 1)) * static_cast<std::size_t>(size.z);
    }
    account(static_cast<std::ptrdiff_t>(bytes_));
    set_filter(GL_NEAREST, GL_NEAREST);
    set_wrap(GL_CLAMP_TO_EDGE);
}

Texture::~Texture() {
    if (id_ != 0) {
        glDeleteTextures(1, &id_);
        account(-static_cast<std::ptrdiff_t>(bytes_));
    }
}

Texture::Texture(Texture&& other) noexcept
    : id_(std::exchange(other.id_, 0)),
      target_(other.target_),
      format_(other.format_),
      size_(other.size_),
      bytes_(std::exchange(other.bytes_, 0)) {}

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(target_, other.target_);
    std::swap(format_, other.format_);
    std::swap(size_, other.size_);
    std::swap(bytes_, other.bytes_);
    return *this;
}

void Texture::set_filter(GLenum min, GLenum mag) {
    glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min));
    glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(mag));
}

void Texture::set_wrap(GLenum wrap) {
    for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(id_, axis, static_cast<GLint>(wrap));
    }
}

void Texture::set_depth_compare(bool on) {
    glTextureParameteri(id_, GL_TEXTURE_COMPARE_MODE, on ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
    glTextureParameteri(id_, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void Texture::clear(const vec4& value, int level) {
    glClearTexImage(id_, level, GL_RGBA, GL_FLOAT, &value.x);
}

std::vector<float> Texture::read_floats(int channels, int level) const {
    assert(channels >= 1 && channels <= 4);
    constexpr GLenum kLayouts[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    const std::size_t texels = static_cast<std::size_t>(std::max(size_.x >> level, 1)) *
                               static_cast<std::size_t>(std::max(size_.y >> level, 1)) *
                               static_cast<std::size_t>(size_.z);
    std::vector<float> result(texels * static_cast<std::size_t>(channels));
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    glGetTextureImage(id_, level, kLayouts[channels - 1], GL_FLOAT,
                      static_cast<GLsizei>(result.size() * sizeof(float)), result.data());
    if (format_ == GL_SRGB8_ALPHA8) {  // GL hands out what is stored
        for (std::size_t i = 0; i < result.size(); ++i) {
            const float v = result[i];
            const bool alpha = i % static_cast<std::size_t>(channels) == 3;
            result[i] = alpha ? v : (v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f));
        }
    }
    return result;
}

}  // namespace lanthorn::gpu
