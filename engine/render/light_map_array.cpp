#include "lanthorn/render/light_map_array.h"

#include <algorithm>

#include "lanthorn/core/math.h"

namespace lanthorn::render {

namespace {

constexpr GLenum kDistanceFormat = GL_R32F;
constexpr GLenum kNormalsFormat = GL_RG16_SNORM;
constexpr GLenum kAlbedoFormat = GL_RGBA16F;
constexpr GLenum kDepthFormat = GL_DEPTH_COMPONENT32F;

}  // namespace

bool LightMapArray::allocate(int resolution, int layers) {
    if (resolution == resolution_ && static_cast<std::size_t>(layers) == framebuffers_.size()) {
        return false;
    }
    resolution_ = resolution;
    const ivec2 size(resolution);
    const int allocated = std::max(layers, 1);
    framebuffers_.clear();
    stills_.clear();
    stills_.resize(static_cast<std::size_t>(layers));
    distance_ = gpu::Texture::make_2d_array(kDistanceFormat, size, allocated);
    depth_ = gpu::Texture::make_2d(kDepthFormat, size);
    normals_ = gpu::Texture::make_2d_array(kNormalsFormat, size, allocated);
    if (with_albedo_) {
        albedo_ = gpu::Texture::make_2d_array(kAlbedoFormat, size, allocated);
    }
    for (int layer = 0; layer < layers; ++layer) {
        if (with_albedo_) {
            framebuffers_.push_back(gpu::Framebuffer({&distance_, &normals_, &albedo_}, &depth_, layer));
        } else {
            framebuffers_.push_back(gpu::Framebuffer({&distance_, &normals_}, &depth_, layer));
        }
    }
    return true;
}

void LightMapArray::empty(const gpu::Framebuffer& target) const {
    const vec4 zero(0);
    for (GLint i = 0; i < (with_albedo_ ? 3 : 2); ++i) {
        glClearNamedFramebufferfv(target.id(), GL_COLOR, i, &zero.x);
    }
    glClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &zero.x);
}

void LightMapArray::begin(int layer) {
    const gpu::Framebuffer& target = framebuffers_[static_cast<std::size_t>(layer)];
    target.bind(ivec2(resolution_));
    empty(target);
}

void LightMapArray::begin_still(int layer, bool emptied) {
    std::optional<Still>& still = stills_[static_cast<std::size_t>(layer)];
    const bool fresh = !still;
    if (fresh) {
        const ivec2 size(resolution_);
        still.emplace();
        still->distance = gpu::Texture::make_2d(kDistanceFormat, size);
        still->normals = gpu::Texture::make_2d(kNormalsFormat, size);
        still->depth = gpu::Texture::make_2d(kDepthFormat, size);
        if (with_albedo_) {
            still->albedo = gpu::Texture::make_2d(kAlbedoFormat, size);
            still->framebuffer =
                gpu::Framebuffer({&still->distance, &still->normals, &still->albedo}, &still->depth);
        } else {
            still->framebuffer = gpu::Framebuffer({&still->distance, &still->normals}, &still->depth);
        }
    }
    still->framebuffer.bind(ivec2(resolution_));
    if (fresh || emptied) {
        empty(still->framebuffer);
    }
}

void LightMapArray::begin_over_still(int layer) {
    const Still& still = *stills_[static_cast<std::size_t>(layer)];
    const auto copy = [&](const gpu::Texture& from, const gpu::Texture& to, int to_layer) {
        glCopyImageSubData(from.id(), from.target(), 0, 0, 0, 0, to.id(), to.target(), 0, 0, 0, to_layer,
                           resolution_, resolution_, 1);
    };
    copy(still.distance, distance_, layer);
    copy(still.normals, normals_, layer);
    if (with_albedo_) {
        copy(still.albedo, albedo_, layer);
    }
    copy(still.depth, depth_, 0);
    framebuffers_[static_cast<std::size_t>(layer)].bind(ivec2(resolution_));
}

void LightMapArray::forget_stills() {
    for (std::optional<Still>& still : stills_) {
        still.reset();
    }
}

std::size_t LightMapArray::still_bytes() const {
    std::size_t bytes = 0;
    for (const std::optional<Still>& still : stills_) {
        if (still) {
            bytes += still->distance.bytes() + still->normals.bytes() + still->albedo.bytes() +
                     still->depth.bytes();
        }
    }
    return bytes;
}

}  // namespace lanthorn::render
