#include "lanthorn/scene/sky.h"

#include <algorithm>
#include <cmath>

namespace lanthorn {

double SkyImage::pixel_solid_angle(std::uint32_t y) const {
    const double pi = static_cast<double>(kPi);
    const double upper = std::cos(pi * y / height);
    const double lower = std::cos(pi * (y + 1.0) / height);
    return 2 * pi / width * (upper - lower);
}

vec2 sky_place(const vec3& direction) {
    return {0.5f + std::atan2(direction.z, direction.x) / (2 * kPi),
            std::acos(glm::clamp(direction.y, -1.0f, 1.0f)) / kPi};
}

vec3 sky_direction(const vec2& place) {
    const float longitude = (place.x - 0.5f) * 2 * kPi;
    const float s = std::sin(place.y * kPi);
    return {s * std::cos(longitude), std::cos(place.y * kPi), s * std::sin(longitude)};
}

vec3 sky_radiance(const SkyImage& image, const vec3& direction) {
    const vec2 at =
        sky_place(direction) * vec2(static_cast<float>(image.width), static_cast<float>(image.height)) - 0.5f;
    const auto column = static_cast<int>(std::floor(at.x)), row = static_cast<int>(std::floor(at.y));
    const vec2 part = at - glm::floor(at);
    const int width = static_cast<int>(image.width), height = static_cast<int>(image.height);
    const auto pixel = [&](int x, int y) {
        return image.at(static_cast<std::uint32_t>((x + width) % width),
                        static_cast<std::uint32_t>(glm::clamp(y, 0, height - 1)));
    };
    return glm::mix(glm::mix(pixel(column, row), pixel(column + 1, row), part.x),
                    glm::mix(pixel(column, row + 1), pixel(column + 1, row + 1), part.x), part.y);
}

SkyImage coarser(const SkyImage& image, std::uint32_t height) {
    SkyImage result;
    result.name = image.name;
    result.height = std::min(height, image.height);
    result.width = std::max(std::min(2 * result.height, image.width), 1u);
    std::vector<dvec3> flux(std::size_t{result.width} * result.height, dvec3(0));
    // Each pixel's solid angle goes to the pixels that it overlaps: in columns by their widths, in rows by
    // the heights that are the heights on the sphere (Archimedes).
    const double pi = static_cast<double>(kPi);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        const double top = double(y) / image.height, bottom = (y + 1.0) / image.height;
        const auto first_row = static_cast<std::uint32_t>(top * result.height);
        const auto last_row =
            std::min(static_cast<std::uint32_t>(std::ceil(bottom * result.height - 1e-9)), result.height);
        for (std::uint32_t row = first_row; row < last_row; ++row) {
            const double from = std::max(top, double(row) / result.height);
            const double to = std::min(bottom, (row + 1.0) / result.height);
            const double band = std::cos(pi * from) - std::cos(pi * to);
            for (std::uint32_t x = 0; x < image.width; ++x) {
                const double left = double(x) * result.width / image.width;
                const double right = (x + 1.0) * result.width / image.width;
                const auto last = std::min(static_cast<std::uint32_t>(std::ceil(right - 1e-9)), result.width);
                for (auto column = static_cast<std::uint32_t>(left); column < last; ++column) {
                    const double part = std::min(right, column + 1.0) - std::max(left, double(column));
                    flux[std::size_t{row} * result.width + column] +=
                        dvec3(image.at(x, y)) * (band * part * 2 * pi / result.width);
                }
            }
        }
    }
    result.radiance.resize(flux.size());
    for (std::uint32_t y = 0; y < result.height; ++y) {
        const double angle = result.pixel_solid_angle(y);
        for (std::uint32_t x = 0; x < result.width; ++x) {
            const std::size_t i = std::size_t{y} * result.width + x;
            result.radiance[i] = vec3(flux[i] / angle);
        }
    }
    return result;
}

}  // namespace lanthorn
