#include "engine/render/radiance_picture.h"

#include <cstddef>

namespace lanthorn::render {

RadiancePicture::RadiancePicture(const std::vector<float>& radiance, const std::vector<float>& coverage,
                                 ivec2 size)
    : size_(size), depth_(gpu::Texture::make_2d(GL_DEPTH_COMPONENT32F, size)), composite_(size, depth_) {
    std::vector<float> texels;
    texels.reserve(4 * coverage.size());
    const auto width = static_cast<std::size_t>(size.x);
    for (std::size_t y = static_cast<std::size_t>(size.y); y-- > 0;) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
            texels.insert(texels.end(),
                          {radiance[3 * i], radiance[3 * i + 1], radiance[3 * i + 2], coverage[i]});
        }
    }
    glTextureSubImage2D(composite_.radiance().id(), 0, 0, 0, size.x, size.y, GL_RGBA, GL_FLOAT,
                        texels.data());
}

ImageF RadiancePicture::display(const RenderSettings& settings) {
    composite_.expose(settings, {.reset = true});
    Composite::DisplayInputs over;
    if (settings.bloom_share > 0) {
        over.scattered = &composite_.scatter(settings.bloom_spread);
    }
    composite_.display(settings, over);
    if (settings.antialias) {
        composite_.smooth();
    }
    const std::vector<float> upwards = composite_.final().read_floats(3);
    ImageF image{size_.x, size_.y, 3, {}, {}};
    image.pixels.reserve(upwards.size());
    const auto row = static_cast<std::ptrdiff_t>(3 * static_cast<std::size_t>(size_.x));
    for (std::ptrdiff_t y = size_.y; y-- > 0;) {
        image.pixels.insert(image.pixels.end(), upwards.begin() + y * row, upwards.begin() + (y + 1) * row);
    }
    return image;
}

}  // namespace lanthorn::render
