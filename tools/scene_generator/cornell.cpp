// The Cornell box as measured: geometry, spectra, lamp and camera as published by Cornell University's
// Program of Computer Graphics, https://www.graphics.cornell.edu/online/box/data.html
#include <array>
#include <cmath>

#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

// 400 to 700 nm in steps of 4 nm.
using Spectrum = std::array<double, 76>;
constexpr double wavelength(std::size_t i) {
    return 400.0 + 4.0 * static_cast<double>(i);
}

constexpr Spectrum kWhite = {0.343, 0.445, 0.551, 0.624, 0.665, 0.687, 0.708, 0.723, 0.715, 0.71,  0.745,
                             0.758, 0.739, 0.767, 0.777, 0.765, 0.751, 0.745, 0.748, 0.729, 0.745, 0.757,
                             0.753, 0.75,  0.746, 0.747, 0.735, 0.732, 0.739, 0.734, 0.725, 0.721, 0.733,
                             0.725, 0.732, 0.743, 0.744, 0.748, 0.728, 0.716, 0.733, 0.726, 0.713, 0.74,
                             0.754, 0.764, 0.752, 0.736, 0.734, 0.741, 0.74,  0.732, 0.745, 0.755, 0.751,
                             0.744, 0.731, 0.733, 0.744, 0.731, 0.712, 0.708, 0.729, 0.73,  0.727, 0.707,
                             0.703, 0.729, 0.75,  0.76,  0.751, 0.739, 0.724, 0.73,  0.74,  0.737};
constexpr Spectrum kRed = {0.04,  0.046, 0.048, 0.053, 0.049, 0.05,  0.053, 0.055, 0.057, 0.056, 0.059,
                           0.057, 0.061, 0.061, 0.06,  0.062, 0.062, 0.062, 0.061, 0.062, 0.06,  0.059,
                           0.057, 0.058, 0.058, 0.058, 0.056, 0.055, 0.056, 0.059, 0.057, 0.055, 0.059,
                           0.059, 0.058, 0.059, 0.061, 0.061, 0.063, 0.063, 0.067, 0.068, 0.072, 0.08,
                           0.09,  0.099, 0.124, 0.154, 0.192, 0.255, 0.287, 0.349, 0.402, 0.443, 0.487,
                           0.513, 0.558, 0.584, 0.62,  0.606, 0.609, 0.651, 0.612, 0.61,  0.65,  0.638,
                           0.627, 0.62,  0.63,  0.628, 0.642, 0.639, 0.657, 0.639, 0.635, 0.642};
constexpr Spectrum kGreen = {0.092, 0.096, 0.098, 0.097, 0.098, 0.095, 0.095, 0.097, 0.095, 0.094, 0.097,
                             0.098, 0.096, 0.101, 0.103, 0.104, 0.107, 0.109, 0.112, 0.115, 0.125, 0.14,
                             0.16,  0.187, 0.229, 0.285, 0.343, 0.39,  0.435, 0.464, 0.472, 0.476, 0.481,
                             0.462, 0.447, 0.441, 0.426, 0.406, 0.373, 0.347, 0.337, 0.314, 0.285, 0.277,
                             0.266, 0.25,  0.23,  0.207, 0.186, 0.171, 0.16,  0.148, 0.141, 0.136, 0.13,
                             0.126, 0.123, 0.121, 0.122, 0.119, 0.114, 0.115, 0.117, 0.117, 0.118, 0.12,
                             0.122, 0.128, 0.132, 0.139, 0.144, 0.146, 0.15,  0.152, 0.157, 0.159};

// The CIE 1931 colour matching functions as sums of skewed Gaussians (Wyman, Sloan and Shirley 2013,
// sec. 2.2).
dvec3 colour_matching(double nm) {
    const auto lobe = [nm](double mean, double below, double above) {
        const double t = (nm - mean) / (nm < mean ? below : above);
        return std::exp(-0.5 * t * t);
    };
    return {
        1.056 * lobe(599.8, 37.9, 31.0) + 0.362 * lobe(442.0, 16.0, 26.7) - 0.065 * lobe(501.1, 20.4, 26.2),
        0.821 * lobe(568.8, 46.9, 40.5) + 0.286 * lobe(530.9, 16.3, 31.1),
        1.217 * lobe(437.0, 11.8, 36.0) + 0.681 * lobe(459.0, 26.0, 13.8)};
}

// Linear Rec. 709, scaled a channel so that the constant spectrum 1 (a perfect reflector in equal-energy
// light) is (1, 1, 1): reflectances stay reflectances, and a grey surface stays grey.
template <typename Value>
dvec3 rec709(Value value) {
    const auto integral = [](auto f) {
        dvec3 xyz(0);
        for (std::size_t i = 0; i < Spectrum().size(); ++i) {
            xyz += f(i) * colour_matching(wavelength(i));
        }
        return dvec3(3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
                     -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
                     0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z);
    };
    return integral(value) / integral([](std::size_t) { return 1.0; });
}

// Five digits, so that the last bit of a library's exp() never shows in the file.
vec3 rounded(const dvec3& v) {
    return glm::round(v * 1e5) / 1e5;
}

vec3 reflectance(const Spectrum& spectrum) {
    return rounded(rec709([&](std::size_t i) { return spectrum[i]; }));
}

// Cornell's millimetres, looked at along +z, to metres looked at along -z: half a turn about the vertical.
// The red wall comes to the left of the picture, the green to the right.
dvec3 metres(double x, double y, double z) {
    return 1e-3 * dvec3(-x, y, -z);
}

// The lamp's luminance, cd/m^2: not part of the published data (which is relative). Chosen for 100 to 200 lux
// on the floor.
constexpr double kLampLuminance = 2500;

}  // namespace

SceneData cornell() {
    Builder b;
    const std::uint32_t white = b.matte("white", reflectance(kWhite), 0);
    const std::uint32_t red = b.matte("red", reflectance(kRed), 0);
    const std::uint32_t green = b.matte("green", reflectance(kGreen), 0);

    // The lamp's measured radiance (relative) at 700, 600 and 500 nm stands for its red, green and blue, as
    // in most renderings of the box.
    const dvec3 lamp_rgb(18.4, 15.6, 8.0);
    const double luminance = glm::dot(lamp_rgb, dvec3(0.2126, 0.7152, 0.0722));
    const std::uint32_t panel = b.matte("lamp", vec3(0.78f), 0);  // the panel's measured reflectance
    b.scene.materials[panel].emissive = glm::round(kLampLuminance / luminance * lamp_rgb);

    const dvec3 inside = metres(278, 274.4, 279.6);
    const auto quad = [&](Shape& shape, const dvec3& p, const dvec3& q, const dvec3& r, const dvec3& s) {
        add_quad(shape, p, q, r, s, inside);
    };
    Shape floor, ceiling, back, right, left, lamp_panel;
    quad(floor, metres(552.8, 0, 0), metres(0, 0, 0), metres(0, 0, 559.2), metres(549.6, 0, 559.2));
    quad(back, metres(549.6, 0, 559.2), metres(0, 0, 559.2), metres(0, 548.8, 559.2),
         metres(556, 548.8, 559.2));
    quad(right, metres(0, 0, 559.2), metres(0, 0, 0), metres(0, 548.8, 0), metres(0, 548.8, 559.2));
    quad(left, metres(552.8, 0, 0), metres(549.6, 0, 559.2), metres(556, 548.8, 559.2),
         metres(556, 548.8, 0));

    // The ceiling is a frame around the lamp, which fills its hole: nothing overlaps, nothing gapes.
    const dvec3 outer[] = {metres(556, 548.8, 0), metres(556, 548.8, 559.2), metres(0, 548.8, 559.2),
                           metres(0, 548.8, 0)};
    const dvec3 hole[] = {metres(343, 548.8, 227), metres(343, 548.8, 332), metres(213, 548.8, 332),
                          metres(213, 548.8, 227)};
    for (int i = 0; i < 4; ++i) {
        quad(ceiling, outer[i], outer[(i + 1) % 4], hole[(i + 1) % 4], hole[i]);
    }
    quad(lamp_panel, hole[0], hole[1], hole[2], hole[3]);

    b.solid("floor", floor, white);
    b.solid("ceiling", ceiling, white);
    b.solid("back-wall", back, white);
    b.solid("green-wall", right, green);
    b.solid("red-wall", left, red);
    b.solid("lamp", lamp_panel, panel);
    b.solid("short-block",
            prism({metres(130, 0, 65), metres(82, 0, 225), metres(240, 0, 272), metres(290, 0, 114)}, 0.165),
            white);
    b.solid(
        "tall-block",
        prism({metres(423, 0, 247), metres(265, 0, 296), metres(314, 0, 456), metres(472, 0, 406)}, 0.330),
        white);

    // Focal length 35 mm, film 25 mm square.
    const auto y_fov = static_cast<float>(2 * std::atan(0.5 * 25.0 / 35.0));
    b.camera("camera", at(metres(278, 273, -800)), y_fov, 0.01f);
    return b.scene;
}

}  // namespace lanthorn::scene_generator
