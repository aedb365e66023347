#include "tools/editor/core/error_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanthorn/core/colour.h"

namespace lanthorn::editor {

namespace {

constexpr int kTiles = 8;       // each way: what the figure's uncertainty is found by
constexpr int kNeighbours = 2;  // cells each way that share their estimate of the noise
constexpr double kSure = 2;     // standard errors

// Squared difference to the truth of a cell's three channels, the reference's own taken off it.
struct CellError {
    double squared = 0, mean = 0;
};

}  // namespace

ErrorMap error_map(const reference::SparsePaths& paths, const ImageF& indirect) {
    const reference::Film& film = paths.film();
    ErrorMap map;
    map.cells = paths.cells();
    map.size = {indirect.width, indirect.height};
    map.stride = map.cells.x > 0 ? indirect.width / map.cells.x : 1;
    map.spp = paths.spp();
    const std::size_t count = film.pixels().size();
    map.error.assign(count, std::numeric_limits<float>::quiet_NaN());
    std::vector<CellError> cells(count);
    std::vector<double> off(count), reference(count), variance(count, -1);  // luminance; -1: nothing is seen
    double mean = 0;
    std::size_t lit = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [even, odd] = film.pixels()[i];
        if (!paths.lit(static_cast<int>(i)) || even.count == 0 || odd.count == 0) {
            continue;
        }
        const double a = even.count, b = odd.count;
        const dvec3 found = (even.sum + odd.sum) / (a + b);
        // E (even - odd)^2 a b / (a + b)^2 is the variance of the mean of all (Film::noise()).
        const dvec3 halves = (even.sum / a - odd.sum / b) * std::sqrt(a * b) / (a + b);
        const ivec2 at = paths.pixel(static_cast<int>(i));
        const dvec3 shown(indirect.at(at.x, at.y, 0), indirect.at(at.x, at.y, 1), indirect.at(at.x, at.y, 2));
        const dvec3 difference = shown - found;
        cells[i] = {glm::dot(difference, difference) - glm::dot(halves, halves), found.x + found.y + found.z};
        off[i] = luminance(difference);
        reference[i] = luminance(found);
        variance[i] = luminance(halves) * luminance(halves);
        mean += reference[i];
        ++lit;
    }
    if (lit == 0) {
        return map;
    }
    mean /= static_cast<double>(lit);
    for (int y = 0; y < map.cells.y; ++y) {
        for (int x = 0; x < map.cells.x; ++x) {
            const auto i = static_cast<std::size_t>(y * map.cells.x + x);
            if (variance[i] < 0) {
                continue;
            }
            // Of two halves alone it would be a guess; relative to the light, as neighbours differ in that.
            double sum = 0, weight = 0;
            for (int v = std::max(0, y - kNeighbours); v <= std::min(map.cells.y - 1, y + kNeighbours); ++v) {
                for (int u = std::max(0, x - kNeighbours); u <= std::min(map.cells.x - 1, x + kNeighbours);
                     ++u) {
                    const auto k = static_cast<std::size_t>(v * map.cells.x + u);
                    if (variance[k] >= 0) {
                        sum += variance[k] / (reference[k] * reference[k] + 0.01 * mean * mean);
                        weight += 1;
                    }
                }
            }
            const double scale = std::sqrt(reference[i] * reference[i] + 0.01 * mean * mean);
            const double noise = std::sqrt(sum / weight);
            const double error = scale > 0 ? off[i] / scale : 0;
            map.error[i] = std::abs(error) > kSure * noise ? static_cast<float>(error) : 0.0f;
        }
    }
    // The figure and, by how its tiles differ, how sure it is: neighbouring cells err alike.
    std::vector<CellError> tiles(kTiles * kTiles);
    CellError all;
    for (std::size_t i = 0; i < count; ++i) {
        if (variance[i] < 0) {
            continue;
        }
        const int x = static_cast<int>(i) % map.cells.x, y = static_cast<int>(i) / map.cells.x;
        CellError& tile =
            tiles[static_cast<std::size_t>(y * kTiles / map.cells.y * kTiles + x * kTiles / map.cells.x)];
        for (CellError* sum : {&tile, &all}) {
            sum->squared += cells[i].squared;
            sum->mean += cells[i].mean;
        }
    }
    const double values = 3 * static_cast<double>(lit);
    const double whole = all.mean / values;
    if (!(whole > 0)) {
        return map;
    }
    const double squared = all.squared / values;
    double spread = 0;
    for (const CellError& tile : tiles) {
        const double by = tile.squared - all.squared / (kTiles * kTiles);
        spread += by * by;
    }
    const double sure = std::sqrt(spread * kTiles * kTiles / (kTiles * kTiles - 1.0)) / values;
    map.within_noise = squared <= kSure * sure;
    map.relative = std::sqrt(std::max(0.0, squared)) / whole;
    map.uncertainty =
        squared > 0 && !map.within_noise ? sure / (2 * std::sqrt(squared)) / whole : std::sqrt(sure) / whole;
    return map;
}

}  // namespace lanthorn::editor
