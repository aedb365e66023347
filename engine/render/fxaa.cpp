#include "engine/render/fxaa.h"

#include <array>
#include <cstdint>

namespace lanthorn::render {

namespace {

constexpr GLuint kEdgesBinding = 0;
constexpr std::array<std::uint32_t, 4> kNoEdges = {0, 1, 1, 0};  // work groups; how many
constexpr int kGroup = 8;

}  // namespace

Fxaa::Fxaa(ivec2 size)
    : size_(size),
      source_(gpu::Texture::make_2d(GL_RGBA8, size)),
      edges_(sizeof kNoEdges +
             static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * sizeof(std::uint32_t)),
      list_({"engine/render/fxaa_list.comp"}),
      smooth_({"engine/render/fxaa_smooth.comp"}) {}

void Fxaa::smooth(const gpu::Texture& picture) {
    glCopyImageSubData(picture.id(), GL_TEXTURE_2D, 0, 0, 0, 0, source_.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       size_.x, size_.y, 1);
    edges_.write(0, std::span<const std::uint32_t>(kNoEdges));
    edges_.bind_storage(kEdgesBinding);
    source_.bind(0);
    list_.set("picture", 0);
    list_.use();
    glDispatchCompute(static_cast<GLuint>((size_.x + kGroup - 1) / kGroup),
                      static_cast<GLuint>((size_.y + kGroup - 1) / kGroup), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);

    picture.bind_image(0, GL_WRITE_ONLY);
    smooth_.set("picture", 0);
    smooth_.use();
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, edges_.id());
    glDispatchComputeIndirect(0);
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                    GL_TEXTURE_UPDATE_BARRIER_BIT);
}

}  // namespace lanthorn::render
