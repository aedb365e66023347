#include "engine/render/scene_textures.h"

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

SceneTextures::SceneTextures() : white_(upload({"white", 1, 1, {255, 255, 255, 255}}, false)) {}

void SceneTextures::follow(const SceneAssets& assets) {
    uploaded_bytes_ = 0;
    follow_samplers(assets);
    for (auto& [key, image] : images_) {
        image.used = false;
    }
    materials_.assign(assets.materials.size(), {});
    for (std::size_t slot = 0; slot < materials_.size(); ++slot) {
        Binding& binding = materials_[slot];
        binding.textures.fill(white_.id());
        if (!assets.materials.has(slot)) {
            continue;
        }
        const auto references = assets.materials[slot].textures();
        for (std::size_t i = 0; i < kMaterialTextures; ++i) {
            if (references[i]->present()) {
                const std::uint32_t texture = references[i]->texture;
                binding.textures[i] = texture_of(assets, assets.textures[texture].image, kIsColour[i]);
                binding.samplers[i] = samplers_[texture].id;
            }
        }
    }
    std::erase_if(images_, [](const auto& entry) { return !entry.second.used; });
}

void SceneTextures::follow_samplers(const SceneAssets& assets) {
    for (std::size_t slot = assets.textures.size(); slot < samplers_.size(); ++slot) {
        glDeleteSamplers(1, &samplers_[slot].id);
    }
    samplers_.resize(assets.textures.size());
    for (std::size_t slot = 0; slot < samplers_.size(); ++slot) {
        KeptSampler& kept = samplers_[slot];
        const std::uint64_t version = assets.textures.has(slot) ? assets.textures.version(slot).any : 0;
        if (kept.version != version) {
            glDeleteSamplers(1, &kept.id);  // 0 is none
            kept = {version, version != 0 ? make_sampler(assets.textures[slot].sampler) : 0};
        }
    }
}

GLuint SceneTextures::texture_of(const SceneAssets& assets, std::uint32_t image, bool colour) {
    Uploaded& entry = images_[{image, colour}];
    const std::uint64_t version = assets.images.version(image).any;
    if (entry.version != version) {
        entry.texture = upload(assets.images[image], colour);
        entry.version = version;
        uploaded_bytes_ += assets.images[image].rgba.size();
    }
    entry.used = true;
    return entry.texture.id();
}

SceneTextures::~SceneTextures() {
    for (const KeptSampler& sampler : samplers_) {
        glDeleteSamplers(1, &sampler.id);
    }
}

void SceneTextures::set_bias(float levels) {
    if (levels == bias_) {
        return;
    }
    bias_ = levels;
    for (const KeptSampler& sampler : samplers_) {
        if (sampler.id != 0) {
            glSamplerParameterf(sampler.id, GL_TEXTURE_LOD_BIAS, levels);
        }
    }
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
