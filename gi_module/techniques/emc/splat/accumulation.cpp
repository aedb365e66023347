#include "gi_module/techniques/emc/splat/accumulation.h"

#include <cmath>

namespace lanthorn::gi {

float pass_radius(int pass) {
    constexpr double kAlpha = 2.0 / 3.0;
    // The product (1 + alpha) / 2 * (2 + alpha) / 3 * ... by the gamma function.
    const double squared =
        std::exp(std::lgamma(pass + 1 + kAlpha) - std::lgamma(1 + kAlpha) - std::lgamma(pass + 2.0));
    return static_cast<float>(std::sqrt(squared));
}

const gpu::Texture& Accumulation::add(const gpu::Texture& image, int pass) {
    if (!program_) {
        program_ = gpu::Program({"gi_module/techniques/emc/splat/accumulation.comp"});
    }
    const ivec2 size(image.size());
    if (!mean_ || ivec2(mean_.size()) != size) {
        mean_ = gpu::Texture::make_2d(GL_RGBA32F, size);
    }
    program_.use();
    image.bind(0);
    program_.set("image", 0);
    program_.set("weight", 1.0f / static_cast<float>(pass + 1));
    mean_.bind_image(0, GL_READ_WRITE);
    program_.dispatch(size, ivec2(8));
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    return mean_;
}

}  // namespace lanthorn::gi
