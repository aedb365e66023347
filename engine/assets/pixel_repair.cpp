#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "lanthorn/assets/image_io.h"

namespace lanthorn {

namespace {

class PixelRepair {
  public:
    PixelRepair(const ImageF& image, bool negative, bool round)
        : image_(image), negative_(negative), round_(round) {}

    bool is_sound(float value) const { return std::isfinite(value) && (negative_ || value >= 0); }

    float around(int x, int y, int channel) const {
        std::vector<float> sound;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image_.height - 1); ++v) {
            for (int step = -1; step <= 1; ++step) {
                const int u = round_ ? (x + step + image_.width) % image_.width : x + step;
                if (u < 0 || u >= image_.width) {
                    continue;
                }
                if (const float value = image_.at(u, v, channel); is_sound(value)) {
                    sound.push_back(value);
                }
            }
        }
        if (sound.empty()) {
            return 0;
        }
        const auto middle = sound.begin() + static_cast<std::ptrdiff_t>(sound.size() / 2);
        std::ranges::nth_element(sound, middle);
        return *middle;
    }

  private:
    const ImageF& image_;
    bool negative_, round_;
};

}  // namespace

std::size_t repair_pixels(ImageF& image, bool negative, bool round) {
    const PixelRepair repair(image, negative, round);
    const auto channels = static_cast<std::size_t>(image.channels);
    std::vector<std::pair<std::size_t, float>> values;  // by place: all are of what was sound before
    std::size_t pixels = 0, last = image.pixels.size();
    for (std::size_t at = 0; at < image.pixels.size(); ++at) {
        if (repair.is_sound(image.pixels[at])) {
            continue;
        }
        const std::size_t pixel = at / channels;
        const auto x = static_cast<int>(pixel % static_cast<std::size_t>(image.width));
        const auto y = static_cast<int>(pixel / static_cast<std::size_t>(image.width));
        values.emplace_back(at, repair.around(x, y, static_cast<int>(at % channels)));
        pixels += pixel != std::exchange(last, pixel);
    }
    for (const auto& [at, value] : values) {
        image.pixels[at] = value;
    }
    return pixels;
}

}  // namespace lanthorn
