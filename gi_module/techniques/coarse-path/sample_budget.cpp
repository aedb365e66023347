#include "gi_module/techniques/coarse-path/sample_budget.h"

#include <algorithm>
#include <cmath>

#include "gi_module/reference/random.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::gi {

namespace {

constexpr int kTile = 8;           // cells of the lattice a side
constexpr double kEven = 0.25;     // share of the samples that does not ask for noise
constexpr double kNewlySeen = 3;   // how many times more samples what nothing is known of gets
constexpr double kMost = 16;       // times the mean
constexpr double kDarkest = 0.05;  // of the mean irradiance: error is relative to no less

struct Tile {
    double error = 0;  // sum of squares of the points' relative standard errors
    double points = 0;
};

}  // namespace

std::vector<int> share_samples(const GridPoints& points, std::span<const PointEstimate> known, float mean,
                               float wanted, std::uint32_t frame) {
    const std::size_t count = points.points.size();
    std::vector<int> result(count, 0);
    double light = 0, lit = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (points.points[i].distance > 0) {
            light += static_cast<double>(luminance(known[i].irradiance));
            lit += 1;
        }
    }
    if (lit == 0) {
        return result;
    }
    const double darkest = kDarkest * light / lit;
    const ivec2 grid = (points.cells + kTile - 1) / kTile;
    std::vector<Tile> tiles(static_cast<std::size_t>(grid.x) * static_cast<std::size_t>(grid.y));
    const auto tile_of = [&](std::size_t i) -> Tile& {
        const ivec2 t = points.points[i].xy() / points.spacing / kTile;
        return tiles[static_cast<std::size_t>(t.y) * static_cast<std::size_t>(grid.x) +
                     static_cast<std::size_t>(t.x)];
    };
    for (std::size_t i = 0; i < count; ++i) {
        const double scale = static_cast<double>(luminance(known[i].irradiance)) + darkest;
        if (points.points[i].distance > 0 && known[i].samples >= 2 && scale > 0) {
            Tile& tile = tile_of(i);
            tile.error += static_cast<double>(known[i].variance()) / (scale * scale);
            tile.points += 1;
        }
    }
    double errors = 0, measured = 0;
    for (Tile& tile : tiles) {
        tile.error = tile.points > 0 ? std::sqrt(tile.error / tile.points) : 0;
        errors += tile.error * tile.points;
        measured += tile.points;
    }
    const double mean_error = measured > 0 ? errors / measured : 0;
    std::vector<double> weights(count, 0);
    double total = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (!(points.points[i].distance > 0)) {
            continue;
        }
        const Tile& tile = tile_of(i);
        const double noisy = mean_error > 0 && tile.points > 0 ? tile.error / mean_error : 1;
        const double unknown =
            1 -
            std::min(static_cast<double>(known[i].samples) / std::max(static_cast<double>(wanted), 1.0), 1.0);
        weights[i] = (kEven + (1 - kEven) * std::min(noisy, kMost)) * (1 + kNewlySeen * unknown);
        total += weights[i];
    }
    const double scale = static_cast<double>(mean) * lit / total;
    for (std::size_t i = 0; i < count; ++i) {
        if (!(points.points[i].distance > 0)) {
            continue;
        }
        const std::uint32_t bits =
            reference::mix_bits(reference::mix_bits(points.points[i].pixel) + frame * 0x9e3779b9u);
        const double rate = weights[i] * scale + static_cast<double>(reference::unit_float(bits));
        const int least = known[i].samples > 0 ? 0 : 1;
        result[i] = std::clamp(static_cast<int>(rate), least,
                               static_cast<int>(std::ceil(kMost * static_cast<double>(mean))));
    }
    return result;
}

}  // namespace lanthorn::gi
