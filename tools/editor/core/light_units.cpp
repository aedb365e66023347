#include "tools/editor/core/light_units.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lanthorn/core/colour.h"

namespace lanthorn::editor {

namespace {

constexpr double kPiExact = 3.14159265358979323846;
constexpr double kColdest = 1000, kHottest = 20000;

struct Uv {
    double u, v;
};

// The Planckian locus in CIE 1960 uv (Krystek 1985).
Uv locus(double kelvin) {
    const double t = kelvin, t2 = t * t;
    return {
        (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t2) / (1 + 8.42420235e-4 * t + 7.08145163e-7 * t2),
        (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t2) /
            (1 - 2.89741816e-5 * t + 1.61456053e-7 * t2)};
}

Uv uv_of(const dvec3& rgb) {
    // Rec. 709 to CIE XYZ (ITU-R BT.709, D65).
    const double x = 0.4123908 * rgb.x + 0.3575843 * rgb.y + 0.1804808 * rgb.z;
    const double y = 0.2126390 * rgb.x + 0.7151687 * rgb.y + 0.0721923 * rgb.z;
    const double z = 0.0193308 * rgb.x + 0.1191948 * rgb.y + 0.9505322 * rgb.z;
    const double sum = x + 15 * y + 3 * z;
    return {4 * x / sum, 6 * y / sum};
}

double distance_to(const Uv& uv, double kelvin) {
    const Uv on = locus(kelvin);
    return std::hypot(uv.u - on.u, uv.v - on.v);
}

double strength(const Light& light) {
    return light.intensity * luminance(dvec3(light.colour));
}

// Solid angle times how much of the intensity goes there, of an intensity of 1.
double spread(const Light& light) {
    if (light.type == LightType::directional) {
        return 0;
    }
    if (light.type == LightType::point) {
        return 4 * kPiExact;
    }
    const double outer = std::cos(static_cast<double>(light.outer_cone));
    const double fade = std::max(std::cos(static_cast<double>(light.inner_cone)) - outer, 1e-3);
    return 2 * kPiExact * (1 - (outer + fade) + fade / 3);  // the square of a ramp over `fade`
}

}  // namespace

double lumen(const Light& light) {
    return strength(light) * spread(light);
}

float candela_for_lumen(const Light& light, double lm) {
    const double each = luminance(dvec3(light.colour)) * spread(light);
    return each > 0 ? static_cast<float>(lm / each) : light.intensity;
}

double lux_at_one_metre(const Light& light) {
    return strength(light);
}

float intensity_for_lux(const Light& light, double lux) {
    const double each = luminance(dvec3(light.colour));
    return each > 0 ? static_cast<float>(lux / each) : light.intensity;
}

double reach_of_one_lux(const Light& light) {
    return light.type == LightType::directional ? std::numeric_limits<double>::infinity()
                                                : std::sqrt(std::max(strength(light), 0.0));
}

vec3 colour_of_kelvin(double kelvin) {
    const Uv uv = locus(std::clamp(kelvin, kColdest, kHottest));
    const double x = 1.5 * uv.u / uv.v, z = (4 - uv.u - 10 * uv.v) / (2 * uv.v);  // of Y = 1
    dvec3 rgb(3.2409699 * x - 1.5373832 - 0.4986108 * z, -0.9692436 * x + 1.8759675 + 0.0415551 * z,
              0.0556301 * x - 0.2039770 + 1.0569715 * z);
    rgb = glm::max(rgb, dvec3(0));
    return vec3(rgb / luminance(rgb));
}

Kelvin kelvin_of(const vec3& colour) {
    if (!(luminance(dvec3(colour)) > 0)) {
        return {};
    }
    const Uv uv = uv_of(dvec3(colour));
    double low = kColdest, high = kHottest;
    // Even steps of reciprocal temperature are even steps along the locus.
    const auto kelvin_at = [&](double share) { return 1 / (1 / low + share * (1 / high - 1 / low)); };
    for (int round = 0; round < 6; ++round) {
        int best = 0;
        constexpr int kSteps = 32;
        for (int i = 1; i <= kSteps; ++i) {
            if (distance_to(uv, kelvin_at(i / double(kSteps))) <
                distance_to(uv, kelvin_at(best / double(kSteps)))) {
                best = i;
            }
        }
        const double from = kelvin_at(std::max(best - 1, 0) / double(kSteps));
        const double to = kelvin_at(std::min(best + 1, kSteps) / double(kSteps));
        low = from;
        high = to;
    }
    const double kelvin = 0.5 * (low + high);
    const double off = distance_to(uv, kelvin);
    return {kelvin, uv.v >= locus(kelvin).v ? off : -off};
}

}  // namespace lanthorn::editor
