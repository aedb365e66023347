#include "game/level/night_sky.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace lanthorn::game {

namespace {

constexpr vec3 kZenith(0.018f, 0.036f, 0.090f), kHorizon(0.10f, 0.16f, 0.26f), kHills(0.003f, 0.004f, 0.006f);
constexpr vec3 kMoon(34, 40, 46);                            // nits
constexpr float kMoonRadius = 0.0227f, kHaloRadius = 0.16f;  // radians
constexpr std::uint32_t kRows = 512, kStars = 2600, kLightRows = 16;

// Reproducible on every machine: 0..1 of a counter.
float random_of(std::uint32_t n) {
    n = (n ^ 61u) ^ (n >> 16);
    n *= 9u;
    n ^= n >> 4;
    n *= 0x27d4eb2du;
    n ^= n >> 15;
    return static_cast<float>(n >> 8) / 16777216.0f;
}

// Of waves around the horizon, so that they close: how high hills stand, as the sine of their elevation.
float hills_at(const vec3& direction) {
    const float a = std::atan2(direction.z, direction.x);
    return 0.042f + 0.018f * std::sin(3 * a + 0.7f) + 0.012f * std::sin(7 * a + 2.1f) +
           0.005f * std::sin(17 * a) + 0.003f * std::sin(41 * a + 1);
}

vec3 air_at(const vec3& direction) {
    const float up = std::clamp(direction.y, 0.0f, 1.0f);
    return glm::mix(kHorizon, kZenith, std::pow(up, 0.45f));
}

// The sky without anything in it.
vec3 background_at(const vec3& direction) {
    const float above = direction.y - hills_at(direction);
    return glm::mix(kHills, air_at(direction), std::clamp(above / 0.006f + 0.5f, 0.0f, 1.0f));
}

// Darker seas on the disc.
float seas_at(const vec2& at) {
    const auto sea = [&](float x, float y, float r) {
        return std::clamp(1.4f - glm::distance(at, vec2(x, y)) / r, 0.0f, 1.0f);
    };
    return 1 - 0.4f * std::min(sea(-0.3f, 0.35f, 0.42f) + sea(0.3f, 0.25f, 0.3f) +
                                   sea(-0.45f, -0.15f, 0.36f) + sea(0.5f, -0.1f, 0.2f),
                               1.0f);
}

// Disc and halo.
vec3 moon_at(const vec3& direction, const vec3& moon, const vec3& right, const vec3& up) {
    const float cosine = glm::dot(direction, moon);
    if (cosine < 0.9f) {
        return vec3(0);
    }
    const float angle = std::acos(std::min(cosine, 1.0f));
    const float halo = std::exp(-angle / (0.25f * kHaloRadius));
    const float inside = std::clamp((kMoonRadius - angle) / (0.12f * kMoonRadius) + 0.5f, 0.0f, 1.0f);
    const vec2 on_disc = vec2(glm::dot(direction, right), glm::dot(direction, up)) / kMoonRadius;
    return kMoon * (inside * seas_at(on_disc) + 0.012f * halo);
}

SkyImage image_of(std::uint32_t height) {
    SkyImage image;
    image.name = "night";
    image.width = 2 * height;
    image.height = height;
    image.radiance.reserve(std::size_t{image.width} * height);
    return image;
}

template <class Radiance>
void paint(SkyImage& image, const Radiance& radiance) {
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const vec2 place((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                             (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height));
            image.radiance.push_back(radiance(sky_direction(place)));
        }
    }
}

// A pixel each; many faint ones and few bright.
void add_stars(SkyImage& image) {
    for (std::uint32_t i = 0; i < kStars; ++i) {
        const float up = random_of(4 * i), around = random_of(4 * i + 1);
        const float bright = 0.25f + 5 * std::pow(random_of(4 * i + 2), 9.0f), warm = random_of(4 * i + 3);
        const vec3 direction = sky_direction({around, std::acos(up) / 3.14159265f});
        const vec2 place = sky_place(direction);
        const auto x =
            std::min(static_cast<std::uint32_t>(place.x * static_cast<float>(image.width)), image.width - 1);
        const auto y = std::min(static_cast<std::uint32_t>(place.y * static_cast<float>(image.height)),
                                image.height - 1);
        if (up > hills_at(direction) + 0.02f) {
            const vec3 colour = glm::mix(vec3(0.75f, 0.87f, 1.0f), vec3(1.0f, 0.88f, 0.72f), warm);
            image.radiance[std::size_t{y} * image.width + x] += bright * colour;
        }
    }
}

// Made once: it is the same in every level.
const SkyImage& starry_sky() {
    static const SkyImage sky = [] {
        SkyImage image = image_of(kRows);
        paint(image, background_at);
        add_stars(image);
        return image;
    }();
    return sky;
}

void add_moon(SkyImage& image, const vec3& moon) {
    const vec3 level = std::abs(moon.y) > 0.99f ? vec3(1, 0, 0) : vec3(0, 1, 0);
    const vec3 right = glm::normalize(glm::cross(level, moon)), up = glm::cross(moon, right);
    for (std::uint32_t y = 0; y < image.height; ++y) {
        const float row = (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height);
        if (std::abs(row - sky_place(moon).y) * 3.14159265f > 3 * kHaloRadius) {
            continue;
        }
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const float column = (static_cast<float>(x) + 0.5f) / static_cast<float>(image.width);
            const vec3 direction = sky_direction({column, row});
            if (direction.y < hills_at(direction)) {
                continue;
            }
            const vec3 moonlight = moon_at(direction, moon, right, up);
            vec3& pixel = image.radiance[std::size_t{y} * image.width + x];
            // No star shines through the disc.
            pixel = moonlight + (moonlight.x > 0.2f * kMoon.x ? background_at(direction) : pixel);
        }
    }
}

}  // namespace

Sky night_sky(const vec3& to_moon) {
    static const auto light = [] {
        SkyImage image = image_of(kLightRows);
        paint(image, background_at);
        return std::make_shared<const SkyImage>(std::move(image));
    }();
    auto seen = std::make_shared<SkyImage>(starry_sky());
    add_moon(*seen, glm::normalize(to_moon));
    return {.image = std::move(seen), .light = light};
}

}  // namespace lanthorn::game
