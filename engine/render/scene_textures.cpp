#include "lanthorn/render/scene_textures.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <utility>

namespace lanthorn::render {

namespace {

constexpr std::array<bool, kMaterialTextures> kIsColour{true, false, false, false, true, false, true, false};

// Averages blocks of pixels until both sides fit. (In the stored encoding: damage confined, not a filter.)
Image fitted(const Image& image, std::uint32_t limit) {
    const std::uint32_t bx = (image.width + limit - 1) / limit;
    const std::uint32_t by = (image.height + limit - 1) / limit;
    Image result{image.name, (image.width + bx - 1) / bx, (image.height + by - 1) / by, {}};
    result.rgba.reserve(std::size_t{result.width} * result.height * 4);
    for (std::uint32_t y = 0; y < result.height; ++y) {
        for (std::uint32_t x = 0; x < result.width; ++x) {
            const std::uint32_t x1 = std::min((x + 1) * bx, image.width);
            const std::uint32_t y1 = std::min((y + 1) * by, image.height);
            for (std::size_t channel = 0; channel < 4; ++channel) {
                std::uint64_t sum = 0;
                for (std::uint32_t v = y * by; v < y1; ++v) {
                    for (std::uint32_t u = x * bx; u < x1; ++u) {
                        sum += image.rgba[(std::size_t{v} * image.width + u) * 4 + channel];
                    }
                }
                const std::uint64_t count = std::uint64_t{x1 - x * bx} * (y1 - y * by);
                result.rgba.push_back(static_cast<std::uint8_t>((sum + count / 2) / count));
            }
        }
    }
    return result;
}

gpu::Texture upload(const Image& image, bool colour) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    const auto side = static_cast<std::uint32_t>(limit);
    if (image.width > side || image.height > side) {
        return upload(fitted(image, side), colour);
    }
    const ivec2 size(static_cast<int>(std::max(image.width, 1u)),
                     static_cast<int>(std::max(image.height, 1u)));
    const int levels = std::bit_width(static_cast<unsigned>(std::max(size.x, size.y)));
    gpu::Texture texture = gpu::Texture::make_2d(colour ? GL_SRGB8_ALPHA8 : GL_RGBA8, size, levels);
    if (!image.rgba.empty()) {
        glTextureSubImage2D(texture.id(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                            image.rgba.data());
        glGenerateTextureMipmap(texture.id());
    }
    return texture;
}

GLenum wrap_mode(Wrap wrap) {
    switch (wrap) {
        case Wrap::clamp_to_edge:
            return GL_CLAMP_TO_EDGE;
        case Wrap::mirrored_repeat:
            return GL_MIRRORED_REPEAT;
        case Wrap::repeat:
            break;
    }
    return GL_REPEAT;
}

GLuint make_sampler(const Sampler& s) {
    GLuint id = 0;
    glCreateSamplers(1, &id);
    const GLenum min = s.mipmaps
                           ? (s.min == Filter::linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST)
                           : (s.min == Filter::linear ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(id, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(min));
    glSamplerParameteri(id, GL_TEXTURE_MAG_FILTER, s.mag == Filter::linear ? GL_LINEAR : GL_NEAREST);
    glSamplerParameteri(id, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrap_mode(s.wrap_s)));
    glSamplerParameteri(id, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrap_mode(s.wrap_t)));
    return id;
}

}  // namespace

SceneTextures::SceneTextures(const SceneAssets& assets) {
    textures_.push_back(upload({"white", 1, 1, {255, 255, 255, 255}}, false));
    const GLuint white = textures_.front().id();
    for (std::size_t slot = 0; slot < assets.textures.size(); ++slot) {
        samplers_.push_back(
            make_sampler(assets.textures.has(slot) ? assets.textures[slot].sampler : Sampler{}));
    }
    std::map<std::pair<std::uint32_t, bool>, GLuint> uploaded;  // by image and whether it is colour
    for (std::size_t slot = 0; slot < assets.materials.size(); ++slot) {
        Binding binding;
        const Material none;
        const Material& material = assets.materials.has(slot) ? assets.materials[slot] : none;
        const auto references = material.textures();
        for (std::size_t i = 0; i < kMaterialTextures; ++i) {
            binding.textures[i] = white;
            if (!references[i]->present()) {
                continue;
            }
            const std::uint32_t image = assets.textures[references[i]->texture].image;
            auto [entry, added] = uploaded.try_emplace({image, kIsColour[i]}, 0u);
            if (added) {
                textures_.push_back(upload(assets.images[image], kIsColour[i]));
                entry->second = textures_.back().id();
            }
            binding.textures[i] = entry->second;
            binding.samplers[i] = samplers_[references[i]->texture];
        }
        materials_.push_back(binding);
    }
}

SceneTextures::~SceneTextures() {
    glDeleteSamplers(static_cast<GLsizei>(samplers_.size()), samplers_.data());
}

void SceneTextures::bind(std::uint32_t material) const {
    const Binding& binding = materials_[material];
    glBindTextures(0, static_cast<GLsizei>(kMaterialTextures), binding.textures.data());
    glBindSamplers(0, static_cast<GLsizei>(kMaterialTextures), binding.samplers.data());
}

void SceneTextures::unbind() {
    glBindSamplers(0, static_cast<GLsizei>(kMaterialTextures), nullptr);
}

}  // namespace lanthorn::render
