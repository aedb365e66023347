#include <algorithm>
#include <cmath>

#include "lanthorn/core/colour.h"
#include "lanthorn/scene/sky.h"

namespace lanthorn {

namespace {

constexpr std::uint32_t kCoarseRows = 32;
constexpr std::size_t kMostSuns = 8;

// What lies around a coarse pixel: the mean of its eight neighbours (fewer at the poles' rows).
vec3 surroundings(const SkyImage& image, std::uint32_t x, std::uint32_t y) {
    vec3 sum(0);
    float count = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int row = static_cast<int>(y) + dy;
            if ((dx == 0 && dy == 0) || row < 0 || row >= static_cast<int>(image.height)) {
                continue;
            }
            const int width = static_cast<int>(image.width);
            const auto column = static_cast<std::uint32_t>((static_cast<int>(x) + dx + width) % width);
            sum += image.at(column, static_cast<std::uint32_t>(row));
            ++count;
        }
    }
    return count > 0 ? sum / count : vec3(0);
}

// The range of the image's pixels that share [part / parts, (part + 1) / parts) of it.
struct Range {
    std::uint32_t begin, end;
};
Range share_of(std::uint32_t pixels, std::uint32_t part, std::uint32_t parts) {
    const auto at = [&](std::uint32_t p) {
        return static_cast<std::uint32_t>((std::uint64_t{pixels} * p + parts / 2) / parts);
    };
    return {at(part), std::max(at(part + 1), at(part) + 1)};
}

}  // namespace

std::vector<SkySun> take_suns(SkyImage& image, float share) {
    std::vector<SkySun> suns;
    if (image.height < kCoarseRows || image.width < 2 * kCoarseRows) {
        return suns;  // nothing in it is small
    }
    while (suns.size() < kMostSuns) {
        const SkyImage coarse = coarser(image, kCoarseRows);
        double total = 0, most = 0;
        std::uint32_t at_x = 0, at_y = 0;
        for (std::uint32_t y = 0; y < coarse.height; ++y) {
            for (std::uint32_t x = 0; x < coarse.width; ++x) {
                const double flux = luminance(dvec3(coarse.at(x, y))) * coarse.pixel_solid_angle(y);
                total += flux;
                if (flux > most) {
                    most = flux;
                    at_x = x;
                    at_y = y;
                }
            }
        }
        if (!(most > static_cast<double>(share) * total)) {
            break;
        }
        // What is more than twice as bright as what lies around is the sun's, in the coarse pixel and those
        // next to it, since a sun may lie across their borders.
        const vec3 around = surroundings(coarse, at_x, at_y);
        const double limit = 2 * luminance(dvec3(around));
        dvec3 sum(0), towards(0);
        const Range rows = {share_of(image.height, at_y == 0 ? 0 : at_y - 1, kCoarseRows).begin,
                            share_of(image.height, std::min(at_y + 1, kCoarseRows - 1), kCoarseRows).end};
        const Range columns = share_of(image.width, at_x, coarse.width);
        const std::uint32_t wide = columns.end - columns.begin;
        for (std::uint32_t y = rows.begin; y < rows.end; ++y) {
            const double angle = image.pixel_solid_angle(y);
            for (std::uint32_t k = 0; k < 3 * wide; ++k) {
                const std::uint32_t x = (columns.begin + image.width - wide + k) % image.width;
                vec3& pixel = image.radiance[std::size_t{y} * image.width + x];
                if (luminance(dvec3(pixel)) > limit) {
                    const dvec3 taken = (dvec3(pixel) - dvec3(glm::min(pixel, around))) * angle;
                    const vec2 place((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                                     (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height));
                    towards += luminance(taken) * dvec3(sky_direction(place));
                    sum += taken;
                    pixel = glm::min(pixel, around);
                }
            }
        }
        if (!(luminance(sum) > 0.5 * static_cast<double>(share) * total) || !(glm::length(towards) > 0)) {
            break;  // wide rather than bright
        }
        suns.push_back({vec3(glm::normalize(towards)), vec3(sum)});
    }
    return suns;
}

}  // namespace lanthorn
