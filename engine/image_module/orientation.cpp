#include "engine/image_module/orientation.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace lanthorn {

int radiance_orientation(std::span<const std::uint8_t> bytes) {
    // The first sign and axis, the second sign.
    constexpr std::array<std::string_view, 8> kOrders = {"-Y+", "-Y-", "+Y-", "+Y+",
                                                         "+X-", "-X-", "-X+", "+X+"};
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::size_t header = std::min(text.find("\n\n"), text.find("\n\r\n"));
    if (header == std::string_view::npos) {
        return 1;
    }
    std::string_view line = text.substr(text.find_first_not_of("\r\n", header));
    line = line.substr(0, line.find('\n'));
    const std::size_t second = line.find_first_of("+-", 1);
    if (line.size() < 2 || second == std::string_view::npos) {
        return 1;
    }
    const std::array<char, 3> order = {line[0], line[1], line[second]};
    const auto* const found = std::ranges::find(kOrders, std::string_view(order.data(), order.size()));
    return found == kOrders.end() ? 1 : static_cast<int>(found - kOrders.begin()) + 1;
}

std::vector<float> turned_upright(std::vector<float> pixels, int& width, int& height, int channels,
                                  int orientation) {
    if (orientation < 2 || orientation > 8) {
        return pixels;
    }
    const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
    const auto count = static_cast<std::size_t>(channels);
    const bool exchanged = orientation >= 5;
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool from_below = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    if (exchanged) {
        std::swap(width, height);
    }
    std::vector<float> upright;
    upright.reserve(pixels.size());
    for (std::size_t y = 0; y < (exchanged ? w : h); ++y) {
        for (std::size_t x = 0; x < (exchanged ? h : w); ++x) {
            const std::size_t u = exchanged ? y : x, v = exchanged ? x : y;
            const std::size_t at = (from_below ? h - 1 - v : v) * w + (from_right ? w - 1 - u : u);
            upright.insert(upright.end(), &pixels[at * count], &pixels[at * count] + count);
        }
    }
    return upright;
}

}  // namespace lanthorn
