#include "gi_module/shared/debug/debug_picture.h"

#include <algorithm>

namespace lanthorn::gi {

namespace {

// A point is seen if it is at most this share farther away than what its pixel shows.
constexpr float kBehind = 0.01f;

}  // namespace

void DebugPicture::fill(ivec2 middle, int side, const vec3& colour) {
    const ivec2 lower = glm::max(middle - side / 2, ivec2(0));
    const ivec2 upper = glm::min(middle - side / 2 + side, size_);
    for (int y = lower.y; y < upper.y; ++y) {
        for (int x = lower.x; x < upper.x; ++x) {
            at({x, y}) = vec4(colour, 1);
        }
    }
}

gpu::Texture DebugPicture::texture() const {
    gpu::Texture texture = gpu::Texture::make_2d(GL_RGBA32F, size_);
    glTextureSubImage2D(texture.id(), 0, 0, 0, size_.x, size_.y, GL_RGBA, GL_FLOAT, texels_.data());
    return texture;
}

SeenPoints::SeenPoints(const render::FrameInputs& inputs)
    : camera_(inputs.camera),
      size_(inputs.gbuffer.size()),
      distances_(inputs.gbuffer.distance().read_floats(1)) {}

void SeenPoints::draw(DebugPicture& picture, const vec3& position, const vec3& colour, int side) const {
    const vec3 relative = position - camera_.position;
    const vec4 clip = camera_.clip_from_relative * vec4(relative, 1);
    const vec2 pixel = (vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(size_);
    // Also refuses what is not a number.
    if (!(clip.w > 0 && pixel.x >= 0 && pixel.y >= 0 && pixel.x < static_cast<float>(size_.x) &&
          pixel.y < static_cast<float>(size_.y))) {
        return;
    }
    const ivec2 p(pixel);
    const float shown = distances_[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size_.x) +
                                   static_cast<std::size_t>(p.x)];
    const float distance = camera_.orthographic ? glm::dot(relative, camera_.forward) : glm::length(relative);
    if (shown > 0 && distance <= shown * (1 + kBehind)) {
        picture.fill(p, side, colour);
    }
}

vec3 hue_of(const vec3& light) {
    const float most = std::max({light.x, light.y, light.z});
    return most > 0 ? glm::max(light, vec3(0)) / most : vec3(0);
}

vec3 colour_of(std::uint32_t number) {
    std::uint32_t bits = number * 0x9e3779b9u + 0x7f4a7c15u;
    bits = (bits ^ bits >> 16) * 0x7feb352du;
    bits = (bits ^ bits >> 15) * 0x846ca68bu;
    const auto channel = [&](int shift) {
        return 0.1f + 0.9f * static_cast<float>(bits >> shift & 0xffu) / 255;
    };
    return {channel(0), channel(8), channel(16)};
}

}  // namespace lanthorn::gi
