// Preetham, Shirley and Smits 1999, 'A Practical Analytic Model for Daylight'; eq. 3 is Perez et al. 1993.
#include <algorithm>
#include <array>
#include <cmath>

#include "lanthorn/scene/sky.h"

namespace lanthorn {

namespace {

constexpr double kLowestSun = 0.035;          // radians above the horizon: the model's fit ends there
constexpr double kGroundAlbedo = 0.2;         // grass, bare earth
constexpr double kSolarIlluminance = 127500;  // lux outside the atmosphere

using Perez = std::array<double, 5>;  // A to E of eq. 3

// Luminance at `theta` from the zenith and `gamma` from the sun, but for a factor.
double perez(const Perez& p, double theta, double gamma) {
    const double cosine = std::max(std::cos(theta), 0.01);
    const double cos_gamma = std::cos(gamma);
    return (1 + p[0] * std::exp(p[1] / cosine)) *
           (1 + p[2] * std::exp(p[3] * gamma) + p[4] * cos_gamma * cos_gamma);
}

// Zenith luminance (kcd/m^2) and chromaticities, and how they are spread: appendix A.2.
struct Daylight {
    Perez of_luminance, of_x, of_y;
    double luminance, x, y;
};

Daylight daylight(double turbidity, double sun) {
    const double t = turbidity;
    Daylight d;
    d.of_luminance = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251, 0.1206 * t - 2.5771,
                      -0.0670 * t + 0.3703};
    d.of_x = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125, -0.0641 * t - 0.8989,
              -0.0033 * t + 0.0452};
    d.of_y = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102, -0.0441 * t - 1.6537,
              -0.0109 * t + 0.0529};
    const double pi = static_cast<double>(kPi);
    const double chi = (4.0 / 9 - t / 120) * (pi - 2 * sun);
    d.luminance = std::max((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192, 0.01);
    const auto cubic = [&](double a, double b, double c, double e) {
        return ((a * sun + b) * sun + c) * sun + e;
    };
    d.x = t * t * cubic(0.00166, -0.00375, 0.00209, 0) + t * cubic(-0.02903, 0.06377, -0.03202, 0.00394) +
          cubic(0.11693, -0.21196, 0.06052, 0.25886);
    d.y = t * t * cubic(0.00275, -0.00610, 0.00317, 0) + t * cubic(-0.04214, 0.08970, -0.04153, 0.00516) +
          cubic(0.15346, -0.26756, 0.06670, 0.26688);
    return d;
}

// CIE xyY to linear Rec. 709; what that cannot show is clipped.
dvec3 to_rgb(double x, double y, double luminance) {
    const dvec3 xyz(x / y * luminance, luminance, (1 - x - y) / y * luminance);
    return glm::max(
        dvec3(glm::dot(dvec3(3.2406, -1.5372, -0.4986), xyz), glm::dot(dvec3(-0.9689, 1.8758, 0.0415), xyz),
              glm::dot(dvec3(0.0557, -0.2040, 1.0570), xyz)),
        dvec3(0));
}

double sun_from_zenith(const vec3& to_sun) {
    const double pi = static_cast<double>(kPi);
    return std::min(std::acos(glm::clamp(static_cast<double>(to_sun.y), -1.0, 1.0)), pi / 2 - kLowestSun);
}

// The sun's direction as it is taken: not below the lowest.
dvec3 sun_direction(const vec3& to_sun, double from_zenith) {
    const double length = std::hypot(static_cast<double>(to_sun.x), static_cast<double>(to_sun.z));
    const double x = length > 0 ? static_cast<double>(to_sun.x) / length : 1;
    const double z = length > 0 ? static_cast<double>(to_sun.z) / length : 0;
    return {x * std::sin(from_zenith), std::cos(from_zenith), z * std::sin(from_zenith)};
}

// Share of the sun's light that gets through the air in each band (appendix A.1): Rayleigh's scattering,
// Angstrom's by aerosols and ozone's absorption, at 610, 550 and 465 nm.
dvec3 transmitted(double turbidity, double from_zenith) {
    const double degrees = from_zenith * 180 / static_cast<double>(kPi);
    const double mass = 1 / (std::cos(from_zenith) + 0.15 * std::pow(93.885 - degrees, -1.253));
    const double beta = 0.04608 * turbidity - 0.04586;
    const dvec3 wavelength(0.610, 0.550, 0.465);  // micrometres
    const dvec3 ozone(0.12, 0.085, 0.015);        // per cm, at those
    dvec3 result;
    for (int i = 0; i < 3; ++i) {
        result[i] = std::exp(-mass * (0.008735 * std::pow(wavelength[i], -4.08) +
                                      beta * std::pow(wavelength[i], -1.3) + 0.35 * ozone[i]));
    }
    return result;
}

}  // namespace

Light clear_sun(const vec3& to_sun, float turbidity) {
    const double t = glm::clamp(static_cast<double>(turbidity), 2.0, 10.0);
    const dvec3 through = transmitted(t, sun_from_zenith(to_sun));
    const double strongest = std::max({through.x, through.y, through.z});
    Light light;
    light.type = LightType::directional;
    light.colour = vec3(through / strongest);
    light.intensity = static_cast<float>(kSolarIlluminance * strongest);
    return light;
}

SkyImage clear_sky(const vec3& to_sun, float turbidity, std::uint32_t height) {
    const double t = glm::clamp(static_cast<double>(turbidity), 2.0, 10.0);
    const double from_zenith = sun_from_zenith(to_sun);
    const dvec3 sun = sun_direction(to_sun, from_zenith);
    const Daylight day = daylight(t, from_zenith);
    SkyImage image;
    image.name = "clear sky";
    image.height = std::max(height, 2u);
    image.width = 2 * image.height;
    image.radiance.assign(std::size_t{image.width} * image.height, vec3(0));
    const auto spread = [&](const Perez& p, double zenith, double theta, double gamma) {
        return zenith * perez(p, theta, gamma) / perez(p, 0, from_zenith);
    };
    dvec3 illuminance(0);  // of level ground
    const std::uint32_t horizon = image.height / 2;
    for (std::uint32_t y = 0; y < horizon; ++y) {
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const vec3 d = sky_direction({(static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                                          (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height)});
            const double theta = std::acos(glm::clamp(static_cast<double>(d.y), 0.0, 1.0));
            const double gamma = std::acos(glm::clamp(glm::dot(dvec3(d), sun), -1.0, 1.0));
            const double luminance = 1000 * spread(day.of_luminance, day.luminance, theta, gamma);
            const dvec3 rgb = to_rgb(spread(day.of_x, day.x, theta, gamma),
                                     spread(day.of_y, day.y, theta, gamma), std::max(luminance, 0.0));
            image.radiance[std::size_t{y} * image.width + x] = vec3(rgb);
            illuminance += rgb * (std::cos(theta) * image.pixel_solid_angle(y));
        }
    }
    const Light direct = clear_sun(to_sun, turbidity);
    illuminance += dvec3(direct.colour) * static_cast<double>(direct.intensity) * std::cos(from_zenith);
    const vec3 ground(illuminance * (kGroundAlbedo / static_cast<double>(kPi)));
    std::fill(image.radiance.begin() + std::ptrdiff_t{horizon} * image.width, image.radiance.end(), ground);
    return image;
}

}  // namespace lanthorn
