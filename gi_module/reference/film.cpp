#include "gi_module/reference/film.h"

#include <cmath>
#include <limits>

#include "engine/core/finite.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::reference {

namespace {

void begin_block(Film::Half& half, std::uint32_t block) {
    if (block != half.block) {
        half.before += half.last;
        half.last = dvec3(0);
        half.block = block;
    }
}

}  // namespace

Film::Film(ivec2 size)
    : size_(size), pixels_(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y)) {}

bool Film::add(std::size_t pixel, std::uint32_t sample, const vec3& value) {
    if (!is_finite(value)) {
        return false;
    }
    Half& half = pixels_[pixel][sample & 1u];
    begin_block(half, sample / kBlock);
    half.last += dvec3(value);
    ++half.count;
    return true;
}

void Film::add_block(const Film& other, std::size_t first, std::size_t count) {
    for (std::size_t pixel = first; pixel < first + count; ++pixel) {
        for (std::size_t i = 0; i < 2; ++i) {
            Half& half = pixels_[pixel][i];
            const Half& more = other.pixels_[pixel][i];
            if (more.count > 0) {
                begin_block(half, more.block);
                half.last += more.last;
                half.count += more.count;
            }
        }
    }
}

std::vector<float> Film::mean() const {
    std::vector<float> result;
    result.reserve(3 * pixels_.size());
    for (const auto& [even, odd] : pixels_) {
        const double count = std::max(1.0, static_cast<double>(even.count) + odd.count);
        const vec3 mean((even.sum() + odd.sum()) / count);
        result.insert(result.end(), {mean.x, mean.y, mean.z});
    }
    return result;
}

double Film::noise() const {
    double variance = 0;
    double sum = 0;
    std::size_t valid = 0;
    bool measured = true;
    for (const auto& [even, odd] : pixels_) {
        if (even.sum() + odd.sum() == dvec3(0)) {
            continue;
        }
        const double a = even.count, b = odd.count;
        const dvec3 mean = (even.sum() + odd.sum()) / (a + b);
        sum += mean.x + mean.y + mean.z;
        ++valid;
        if (a == 0 || b == 0) {
            measured = false;
            continue;
        }
        const dvec3 difference = even.sum() / a - odd.sum() / b;
        variance += glm::dot(difference, difference) * a * b / ((a + b) * (a + b));
    }
    if (valid == 0) {
        return 0;
    }
    if (!measured) {
        return std::numeric_limits<double>::infinity();
    }
    const double values = 3 * static_cast<double>(valid);
    return std::sqrt(variance / values) / (sum / values);
}

}  // namespace lanthorn::reference
