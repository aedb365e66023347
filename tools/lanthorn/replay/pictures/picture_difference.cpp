#include "tools/lanthorn/replay/pictures/picture_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "lanthorn/core/error.h"
#include "lanthorn/workbench/flip.h"
#include "tools/lanthorn/replay/pictures/picture_figures.h"

namespace lanthorn::tools {

namespace {

// How often the largest difference of a few pictures another one may be.
constexpr double kFactor = 1.5;
constexpr double kSlack = 0.5 / 255;

}  // namespace

PictureDifference& PictureDifference::widen(const PictureDifference& other) {
    flip = std::max(flip, other.flip);
    worst_tile = std::max(worst_tile, other.worst_tile);
    return *this;
}

std::string PictureDifference::beyond(const PictureDifference& floor) const {
    // Also where one of them is no number.
    if (!(flip <= kFactor * floor.flip + kSlack)) {
        return "FLIP";
    }
    return worst_tile <= kFactor * floor.worst_tile + kSlack ? "" : "worst tile";
}

PictureDifference picture_difference(const ImageF& shown, const ImageF& expected, const std::string& what) {
    if (shown.width != expected.width || shown.height != expected.height || expected.channels < 3) {
        throw InputError(what, "",
                         fmt::format("found {}x{} pixels of {} channels, expected {}x{} of 3", expected.width,
                                     expected.height, expected.channels, shown.width, shown.height));
    }
    const std::vector<float> seen = workbench::flip(shown, expected);
    PictureDifference d;
    d.flip = std::accumulate(seen.begin(), seen.end(), 0.0) / static_cast<double>(seen.size());
    for (int y0 = 0; y0 < shown.height; y0 += kTilePixels) {
        for (int x0 = 0; x0 < shown.width; x0 += kTilePixels) {
            const int x1 = std::min(x0 + kTilePixels, shown.width),
                      y1 = std::min(y0 + kTilePixels, shown.height);
            double sum = 0;
            for (int y = y0; y < y1; ++y) {
                const auto row = seen.begin() + static_cast<std::ptrdiff_t>(y) * shown.width;
                sum = std::accumulate(row + x0, row + x1, sum);
            }
            if (const double mean = sum / ((x1 - x0) * (y1 - y0)); mean > d.worst_tile) {
                d.worst_tile = mean;
                d.worst_x = x0 / kTilePixels;
                d.worst_y = y0 / kTilePixels;
            }
        }
    }
    return d;
}

std::string difference_words(const PictureDifference& d) {
    return fmt::format("FLIP {:.4f}, worst tile ({}, {}) {:.3f}", d.flip, d.worst_x, d.worst_y, d.worst_tile);
}

bool equal_in_8_bits(const ImageF& a, const ImageF& b) {
    const auto as_byte = [](float v) { return std::lround(255 * v); };
    return std::ranges::equal(a.pixels, b.pixels, {}, as_byte, as_byte);
}

}  // namespace lanthorn::tools
