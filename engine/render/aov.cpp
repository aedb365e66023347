// Reading a frame's pictures back.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "engine/render/frame_targets.h"

namespace lanthorn::render {

namespace {

ImageF read_back(const gpu::Texture& texture, int channels) {
    const ivec2 size(texture.size());
    ImageF image{size.x, size.y, channels, {}, {}};
    const std::vector<float> upwards = texture.read_floats(channels);
    const std::size_t row = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(channels);
    image.pixels.reserve(upwards.size());
    for (std::size_t y = static_cast<std::size_t>(size.y); y-- > 0;) {
        const auto begin = upwards.begin() + static_cast<std::ptrdiff_t>(y * row);
        image.pixels.insert(image.pixels.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
    }
    return image;
}

// Octahedral xy of each 4-channel pixel to a unit vector (octahedral.glsl); 0 where nothing is seen.
ImageF decode_normals(const ImageF& stored, const ImageF& distance) {
    ImageF image{stored.width, stored.height, 3, {}, {}};
    for (std::size_t i = 0; i < distance.pixels.size(); ++i) {
        vec3 n(stored.pixels[4 * i], stored.pixels[4 * i + 1], 0);
        n.z = 1 - std::abs(n.x) - std::abs(n.y);
        const float fold = std::max(-n.z, 0.0f);
        n.x += n.x >= 0 ? -fold : fold;
        n.y += n.y >= 0 ? -fold : fold;
        n = distance.pixels[i] > 0 ? glm::normalize(n) : vec3(0);
        image.pixels.insert(image.pixels.end(), {n.x, n.y, n.z});
    }
    return image;
}

ImageF diffuse_albedo(const ImageF& stored) {
    ImageF image{stored.width, stored.height, 3, {}, {}};
    for (std::size_t i = 0; i + 3 < stored.pixels.size(); i += 4) {
        const float share = 1 - stored.pixels[i + 3];
        for (std::size_t c = 0; c < 3; ++c) {
            image.pixels.push_back(stored.pixels[i + c] * share);
        }
    }
    return image;
}

}  // namespace

ImageF FrameRenderer::read(Aov aov) const {
    assert(targets_);
    const GBuffer& gbuffer = targets_->gbuffer;
    switch (aov) {
        case Aov::final:
            return read_back(final(), 3);
        case Aov::radiance:
            return read_back(targets_->composite.radiance(), 3);
        case Aov::direct:
            return read_back(targets_->direct.radiance(), 3);
        case Aov::albedo:
            return diffuse_albedo(read_back(gbuffer.albedo(), 4));
        case Aov::normal:
            return decode_normals(read_back(gbuffer.normals(), 4), read_back(gbuffer.distance(), 1));
        case Aov::depth:
            return read_back(gbuffer.distance(), 1);
        case Aov::indirect:
            break;
    }
    if (indirect_.irradiance != nullptr) {
        return read_back(*indirect_.irradiance, 3);
    }
    const ivec2 size = gbuffer.size();
    const std::size_t values = 3 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    return {size.x, size.y, 3, std::vector<float>(values), {}};
}

}  // namespace lanthorn::render
