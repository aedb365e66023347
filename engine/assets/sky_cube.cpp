#include "engine/assets/sky_cube.h"

#include <algorithm>
#include <cmath>

namespace lanthorn {

namespace {

constexpr std::uint32_t kMostRows = 4096;
constexpr std::uint32_t kHarmonicRows = 32;  // the second band has a wavelength of half the height
constexpr int kLooks = 2;                    // a pixel and axis

// To the right and down in the image of each face, and towards its middle.
struct Face {
    vec3 right, down, towards;
};
const std::array<Face, 6> kFaces = {{{{0, 0, 1}, {0, -1, 0}, {1, 0, 0}},
                                     {{0, 0, -1}, {0, -1, 0}, {-1, 0, 0}},
                                     {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                     {{-1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                     {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
                                     {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}};

std::size_t face_of(const vec3& d) {
    const vec3 a = glm::abs(d);
    if (a.x >= a.y && a.x >= a.z) {
        return d.x >= 0 ? 0 : 1;
    }
    if (a.y >= a.z) {
        return d.y >= 0 ? 2 : 3;
    }
    return d.z >= 0 ? 4 : 5;
}

// Solid angle of the rectangle from the middle of a face to (x, y), in half sides.
double solid_angle_to(double x, double y) {
    return std::atan2(x * y, std::sqrt(x * x + y * y + 1));
}

dvec3 flux_of(const SkyCube& cube) {
    dvec3 flux(0);
    const double side = 2.0 / cube.size;
    for (std::uint32_t y = 0; y < cube.size; ++y) {
        for (std::uint32_t x = 0; x < cube.size; ++x) {
            const double left = x * side - 1, right = left + side, top = y * side - 1, bottom = top + side;
            const double angle = solid_angle_to(right, bottom) - solid_angle_to(left, bottom) -
                                 solid_angle_to(right, top) + solid_angle_to(left, top);
            for (const std::vector<vec3>& face : cube.faces) {
                flux += dvec3(face[std::size_t{y} * cube.size + x]) * angle;
            }
        }
    }
    return flux;
}

dvec3 flux_of(const SkyImage& image) {
    dvec3 flux(0);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            flux += dvec3(image.at(x, y)) * image.pixel_solid_angle(y);
        }
    }
    return flux;
}

void scale_to(SkyImage& image, const dvec3& wanted) {
    const dvec3 found = flux_of(image);
    vec3 scale;
    for (int c = 0; c < 3; ++c) {
        scale[c] = found[c] > 0 ? static_cast<float>(std::max(wanted[c], 0.0) / found[c]) : 0.0f;
    }
    for (vec3& pixel : image.radiance) {
        pixel *= scale;
    }
}

template <class Look>
SkyImage image_of(std::uint32_t height, const Look& look) {
    SkyImage image;
    image.height = height;
    image.width = 2 * height;
    image.radiance.reserve(std::size_t{image.width} * image.height);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            vec3 sum(0);
            for (int k = 0; k < kLooks * kLooks; ++k) {
                const vec2 within = (vec2(k % kLooks, k / kLooks) + 0.5f) / static_cast<float>(kLooks);
                sum += look(sky_direction((vec2(x, y) + within) / vec2(image.width, image.height)));
            }
            image.radiance.push_back(sum / static_cast<float>(kLooks * kLooks));
        }
    }
    return image;
}

}  // namespace

vec3 SkyCube::radiance(const vec3& direction) const {
    const std::size_t f = face_of(direction);
    const Face& face = kFaces[f];
    const float depth = glm::dot(direction, face.towards);
    const vec2 plane(glm::dot(direction, face.right) / depth, glm::dot(direction, face.down) / depth);
    const float last = static_cast<float>(size - 1);
    const vec2 at = glm::clamp((plane * 0.5f + 0.5f) * static_cast<float>(size) - 0.5f, vec2(0), vec2(last));
    const uvec2 low(at), high = glm::min(low + 1u, uvec2(size - 1));
    const vec2 part = at - vec2(low);
    const auto pixel = [&](std::uint32_t x, std::uint32_t y) { return faces[f][std::size_t{y} * size + x]; };
    return glm::mix(glm::mix(pixel(low.x, low.y), pixel(high.x, low.y), part.x),
                    glm::mix(pixel(low.x, high.y), pixel(high.x, high.y), part.x), part.y);
}

SkyImage sky_of_cube(const SkyCube& cube) {
    SkyImage image = image_of(std::clamp(2 * cube.size, 2u, kMostRows),
                              [&](const vec3& direction) { return cube.radiance(direction); });
    scale_to(image, flux_of(cube));
    return image;
}

SkyImage sky_of_harmonics(const IrradianceHarmonics& irradiance) {
    // Irradiance is radiance with each band weakened by the clamped cosine: pi, 2 pi / 3, pi / 4.
    constexpr std::array<float, 9> kCosine = {kPi,     2 * kPi / 3, 2 * kPi / 3, 2 * kPi / 3, kPi / 4,
                                              kPi / 4, kPi / 4,     kPi / 4,     kPi / 4};
    const auto radiance = [&](const vec3& d) {
        const std::array<float, 9> y = {0.282095f,
                                        0.488603f * d.y,
                                        0.488603f * d.z,
                                        0.488603f * d.x,
                                        1.092548f * d.x * d.y,
                                        1.092548f * d.y * d.z,
                                        0.315392f * (3 * d.z * d.z - 1),
                                        1.092548f * d.x * d.z,
                                        0.546274f * (d.x * d.x - d.y * d.y)};
        vec3 sum(0);
        for (std::size_t i = 0; i < y.size(); ++i) {
            sum += irradiance[i] * (y[i] / kCosine[i]);
        }
        return glm::max(sum, vec3(0));
    };
    SkyImage image = image_of(kHarmonicRows, radiance);
    const double pi = static_cast<double>(kPi);
    scale_to(image, dvec3(irradiance[0]) * (0.282095 / pi * 4 * pi));  // the other bands have none
    return image;
}

}  // namespace lanthorn
