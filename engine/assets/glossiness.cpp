#include "engine/assets/glossiness.h"

#include <cmath>

namespace lanthorn {

void roughness_of_glossiness(Image& image, double factor) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const double glossiness = factor * image.rgba[i + 3];
        image.rgba[i] = 0;
        image.rgba[i + 1] = static_cast<std::uint8_t>(std::lround(255 - glossiness));
        image.rgba[i + 2] = 0;
        image.rgba[i + 3] = 255;
    }
}

}  // namespace lanthorn
