#include "engine/image_module/windowed_picture.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace lanthorn {

std::vector<float> whole_of(WindowedPicture picture) {
    if (picture.x == 0 && picture.y == 0 && picture.width == picture.full_width &&
        picture.height == picture.full_height) {
        return std::move(picture.pixels);
    }
    const auto channels = static_cast<std::size_t>(picture.channels);
    const auto full_width = static_cast<std::size_t>(picture.full_width);
    std::vector<float> whole(full_width * static_cast<std::size_t>(picture.full_height) * channels);
    const long left = std::max(picture.x, 0),
               right = std::min(long{picture.x} + picture.width, long{picture.full_width});
    const long top = std::max(picture.y, 0),
               bottom = std::min(long{picture.y} + picture.height, long{picture.full_height});
    for (long y = top; y < bottom && left < right; ++y) {
        const auto row = static_cast<std::size_t>(y - picture.y) * static_cast<std::size_t>(picture.width);
        const float* from = &picture.pixels[(row + static_cast<std::size_t>(left - picture.x)) * channels];
        std::copy_n(
            from, static_cast<std::size_t>(right - left) * channels,
            &whole[(static_cast<std::size_t>(y) * full_width + static_cast<std::size_t>(left)) * channels]);
    }
    return whole;
}

}  // namespace lanthorn
