// Skies: light that comes from far away all around, from an image or from a model of a clear day.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/scene/light.h"

namespace lanthorn {

// Radiance by direction, equirectangular: rows from the zenith (+Y) down to the nadir, columns by longitude,
// the middle of the image towards +X and three quarters of it towards +Z. Made once, then shared and never
// changed.
struct SkyImage {
    std::string name;
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<vec3> radiance;  // width * height; linear RGB, nits at Sky::intensity 1; finite, >= 0

    // Of a pixel: column from the left, row from the top; both must be inside, which is not checked.
    const vec3& at(std::uint32_t x, std::uint32_t y) const { return radiance[std::size_t{y} * width + x]; }
    // Solid angle of a pixel of row y, in steradians: exact, so that all of them sum up to 4 pi.
    double pixel_solid_angle(std::uint32_t y) const;
};

// Where a unit direction lies in an equirectangular image, 0..1 from its upper left corner; and back.
vec2 sky_place(const vec3& direction);
// A unit vector; `place.y` 0 is up (+Y), 1 down.
vec3 sky_direction(const vec2& place);

// Radiance from a unit direction, bilinear between pixel centres. The image must have pixels.
vec3 sky_radiance(const SkyImage& image, const vec3& direction);

// The mean over areas, at most `height` rows: what the image looks like from afar. The same flux.
SkyImage coarser(const SkyImage& image, std::uint32_t height);

// What an entity's rotation turns, and what is shown and shines behind everything.
struct Sky {
    std::shared_ptr<const SkyImage> image;  // what the camera sees; null: black
    // What lights the scene: `image`, or without suns that are separate lights; null: as `image`.
    std::shared_ptr<const SkyImage> light;
    vec3 colour{1};       // factor, linear RGB
    float intensity = 1;  // factor

    // Null: the sky is black.
    const std::shared_ptr<const SkyImage>& lights_by() const { return light ? light : image; }
    bool operator==(const Sky&) const = default;
};

// A sun taken out of an image: a directional light that stands for it.
struct SkySun {
    vec3 towards{0, 1, 0};  // unit
    vec3 illuminance{0};    // lux on a surface square to it, linear RGB
};
// Takes out of the image what is so bright and small that rays find it by chance alone: spots which give more
// than `share` of all the light of their 64 x 32 nd of the sphere's directions, brightest first, eight at
// most. What is left there is what lies around them. The flux of image and suns together stays as it was.
std::vector<SkySun> take_suns(SkyImage& image, float share = 0.02f);

// A clear day (Preetham, Shirley and Smits 1999, 'A Practical Analytic Model for Daylight'), turbidity 2 to
// 10; below the horizon ground of albedo 0.2 that sky and sun light. `to_sun`: unit; taken as at least 2
// degrees above the horizon. The sun itself is not in the image. O(pixels).
SkyImage clear_sky(const vec3& to_sun, float turbidity = 3, std::uint32_t height = 64);
// The light of that day's sun: directional, its colour and lux by how much air it passes (Preetham et al.
// 1999, appendix A.1, with the mean of Rayleigh's and Angstrom's terms over the visible bands).
Light clear_sun(const vec3& to_sun, float turbidity = 3);

}  // namespace lanthorn
