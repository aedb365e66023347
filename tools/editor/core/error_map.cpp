#include "tools/editor/core/error_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanthorn/core/colour.h"

namespace lanthorn::editor {

namespace {

constexpr int kTiles = 8;        // each way: what the figure's uncertainty is found by
constexpr int kNeighbours = 2;   // cells each way that are judged together
constexpr double kSure = 2;      // standard errors
constexpr double kShare = 0.01;  // of the squared mean: what keeps the error of black places finite

// Luminance.
struct Cell {
    bool seen = false;
    double off = 0;  // picture less reference
    double reference = 0;
    double variance = 0;  // of the reference's mean, by its halves
};

std::size_t cell_index(const ivec2& size, int x, int y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
}

struct Around {
    double off = 0, reference = 0, noise = 0;
};

std::vector<Cell> cells_of(const reference::SparsePaths& paths, const ImageF& indirect) {
    const auto& pixels = paths.film().pixels();
    std::vector<Cell> cells(pixels.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& [even, odd] = pixels[i];
        if (!paths.lit(static_cast<int>(i)) || even.count == 0 || odd.count == 0) {
            continue;
        }
        const double a = even.count, b = odd.count;
        const ivec2 at = paths.pixel(static_cast<int>(i));
        const dvec3 shown(indirect.at(at.x, at.y, 0), indirect.at(at.x, at.y, 1), indirect.at(at.x, at.y, 2));
        cells[i].seen = true;
        cells[i].reference = luminance((even.sum() + odd.sum()) / (a + b));
        cells[i].off = luminance(shown) - cells[i].reference;
        // E (even - odd)^2 a b / (a + b)^2 is the variance of the mean of all (Film::noise()).
        const double halves = luminance(even.sum() / a - odd.sum() / b) * std::sqrt(a * b) / (a + b);
        cells[i].variance = halves * halves;
    }
    return cells;
}

// The mean of what lies around a cell that is seen, and its standard error: by the halves, or by how the
// places differ if that is more. Few samples of a light that is rarely hit look quieter than they are.
Around around(const std::vector<Cell>& cells, ivec2 size, ivec2 at) {
    Around result;
    double variance = 0, squares = 0, count = 0;
    for (int y = std::max(0, at.y - kNeighbours); y <= std::min(size.y - 1, at.y + kNeighbours); ++y) {
        for (int x = std::max(0, at.x - kNeighbours); x <= std::min(size.x - 1, at.x + kNeighbours); ++x) {
            const Cell& cell = cells[cell_index(size, x, y)];
            if (cell.seen) {
                result.off += cell.off;
                result.reference += cell.reference;
                variance += cell.variance;
                squares += cell.off * cell.off;
                count += 1;
            }
        }
    }
    result.off /= count;
    result.reference /= count;
    const double spread = std::max(0.0, squares / count - result.off * result.off) / std::max(1.0, count - 1);
    result.noise = std::sqrt(std::max(variance / (count * count), spread));
    return result;
}

}  // namespace

ErrorMap error_map(const reference::SparsePaths& paths, const ImageF& indirect) {
    ErrorMap map;
    map.cells = paths.cells();
    map.size = {indirect.width, indirect.height};
    map.stride = map.cells.x > 0 ? indirect.width / map.cells.x : 1;
    map.spp = paths.spp();
    const std::vector<Cell> cells = cells_of(paths, indirect);
    map.error.assign(cells.size(), std::numeric_limits<float>::quiet_NaN());
    double mean = 0, seen = 0;
    for (const Cell& cell : cells) {
        mean += cell.seen ? cell.reference : 0;
        seen += cell.seen ? 1 : 0;
    }
    if (!(mean > 0)) {
        return map;
    }
    mean /= seen;
    // The figure and, by how its tiles differ, how sure it is: neighbouring cells err alike.
    std::vector<double> tiles(kTiles * kTiles);
    double sum = 0;
    for (int y = 0; y < map.cells.y; ++y) {
        for (int x = 0; x < map.cells.x; ++x) {
            const std::size_t i = cell_index(map.cells, x, y);
            if (!cells[i].seen) {
                continue;
            }
            const Around here = around(cells, map.cells, {x, y});
            const double scale2 = here.reference * here.reference + kShare * mean * mean;
            const double error = here.off / std::sqrt(scale2);
            map.error[i] = std::abs(here.off) > kSure * here.noise ? static_cast<float>(error) : 0.0f;
            const double squared = (cells[i].off * cells[i].off - cells[i].variance) / scale2;
            tiles[cell_index(ivec2(kTiles), x * kTiles / map.cells.x, y * kTiles / map.cells.y)] += squared;
            sum += squared;
        }
    }
    double spread = 0;
    for (const double tile : tiles) {
        const double by = tile - sum / (kTiles * kTiles);
        spread += by * by;
    }
    const double squared = sum / seen;
    const double sure = std::sqrt(spread * kTiles * kTiles / (kTiles * kTiles - 1.0)) / seen;  // of `squared`
    map.within_noise = squared <= kSure * sure;
    map.local = std::sqrt(std::max(0.0, squared));
    map.uncertainty = map.within_noise ? std::sqrt(sure) : sure / (2 * map.local);
    return map;
}

}  // namespace lanthorn::editor
