#include "lanthorn/workbench/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lanthorn/core/colour.h"
#include "lanthorn/core/math.h"

namespace lanthorn::workbench {

namespace {

using std::numbers::pi;

using Plane = std::vector<double>;
struct Planes {
    int width = 0, height = 0;
    std::array<Plane, 3> c;
};

// Rec. 709 primaries, D65, as rational numbers of the reference implementation.
constexpr double kToXyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                                 {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                                 {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};

// XYZ relative to the white of this matrix.
dvec3 relative_xyz(const dvec3& rgb) {
    dvec3 xyz;
    for (int i = 0; i < 3; ++i) {
        const auto& row = kToXyz[i];
        xyz[i] = (row[0] * rgb.r + row[1] * rgb.g + row[2] * rgb.b) / (row[0] + row[1] + row[2]);
    }
    return xyz;
}

dvec3 opponent(const dvec3& rgb) {  // YCxCz
    const dvec3 t = relative_xyz(rgb);
    return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)};
}

dvec3 rgb_of_opponent(const dvec3& ycc) {
    glm::dmat3 to_xyz;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            to_xyz[column][row] = kToXyz[row][column];
        }
    }
    static const glm::dmat3 from_xyz = glm::inverse(to_xyz);
    static const dvec3 white = to_xyz * dvec3(1);
    const double y = (ycc.x + 16) / 116;
    return from_xyz * (white * dvec3(y + ycc.y / 500, y, y - ycc.z / 200));
}

// CIELAB with the Hunt effect: chroma counts for less in the dark.
dvec3 hunt_lab(const dvec3& rgb) {
    const dvec3 t = relative_xyz(rgb);
    dvec3 f;
    for (int i = 0; i < 3; ++i) {
        constexpr double kDelta = 6.0 / 29.0;
        f[i] = t[i] > kDelta * kDelta * kDelta ? std::cbrt(t[i]) : t[i] / (3 * kDelta * kDelta) + 4.0 / 29.0;
    }
    const double l = 116 * f.y - 16;
    return {l, 0.01 * l * 500 * (f.x - f.y), 0.01 * l * 200 * (f.y - f.z)};
}

double hyab(const dvec3& a, const dvec3& b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// Convolution with `kernel_x` along rows and `kernel_y` along columns, edges repeated.
Plane convolve(const Plane& in, int width, int height, const std::vector<double>& kernel_x,
               const std::vector<double>& kernel_y) {
    const auto pass = [&](const Plane& source, const std::vector<double>& kernel, int dx, int dy) {
        const int radius = static_cast<int>(kernel.size()) / 2;
        Plane out(source.size());
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                double sum = 0;
                for (int k = -radius; k <= radius; ++k) {
                    const int sx = std::clamp(x + k * dx, 0, width - 1);
                    const int sy = std::clamp(y + k * dy, 0, height - 1);
                    sum += kernel[static_cast<std::size_t>(k + radius)] *
                           source[static_cast<std::size_t>(sy) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(sx)];
                }
                out[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)] = sum;
            }
        }
        return out;
    };
    return pass(pass(in, kernel_x, 1, 0), kernel_y, 0, 1);
}

template <typename F>
std::vector<double> kernel(int radius, F f) {
    std::vector<double> weights;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(f(static_cast<double>(x)));
    }
    return weights;
}

double sum(const std::vector<double>& weights) {
    double total = 0;
    for (const double w : weights) {
        total += w;
    }
    return total;
}

// The contrast sensitivity functions as sums of Gaussians a sqrt(pi/b) exp(-pi^2 z/b) (their table 1).
Plane contrast_filter(const Plane& in, int width, int height, int channel, double ppd) {
    struct Term {
        double a, b;
    };
    constexpr std::array<std::array<Term, 2>, 3> kTerms = {
        {{{{1, 0.0047}, {0, 1e-5}}}, {{{1, 0.0053}, {0, 1e-5}}}, {{{34.1, 0.04}, {13.5, 0.025}}}}};
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
    Plane out(in.size(), 0);
    double total = 0;
    for (const Term& term : kTerms[static_cast<std::size_t>(channel)]) {
        if (term.a == 0) {
            continue;
        }
        const auto g =
            kernel(radius, [&](double x) { return std::exp(-pi * pi * (x / ppd) * (x / ppd) / term.b); });
        const double weight = term.a * std::sqrt(pi / term.b);
        total += weight * sum(g) * sum(g);
        const Plane part = convolve(in, width, height, g, g);
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i] += weight * part[i];
        }
    }
    for (double& value : out) {
        value /= total;
    }
    return out;
}

// Length of the gradient (edges) or of the second derivative (points) of the luminance.
Plane features(const Plane& luminance, int width, int height, bool points, double ppd) {
    const double sd = 0.5 * 0.082 * ppd;
    const int radius = static_cast<int>(std::ceil(3 * sd));
    auto g = kernel(radius, [&](double x) { return std::exp(-x * x / (2 * sd * sd)); });
    auto d = kernel(radius, [&](double x) {
        return (points ? x * x / (sd * sd) - 1 : -x) * std::exp(-x * x / (2 * sd * sd));
    });
    const double g_sum = sum(g);
    double positive = 0, negative = 0;
    for (const double w : d) {
        (w > 0 ? positive : negative) += std::abs(w);
    }
    for (double& w : g) {
        w /= g_sum;
    }
    for (double& w : d) {
        w /= w > 0 ? positive : negative;
    }
    const Plane along_x = convolve(luminance, width, height, d, g);
    const Plane along_y = convolve(luminance, width, height, g, d);
    Plane out(luminance.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = std::hypot(along_x[i], along_y[i]);
    }
    return out;
}

struct Seen {
    std::vector<dvec3> colours;  // filtered, in Hunt-adjusted CIELAB
    Plane edges, points;
};

Seen see(const ImageF& image, Encoding encoding, double ppd) {
    Planes ycc{image.width, image.height, {}};
    const std::size_t count = image.pixels.size() / static_cast<std::size_t>(image.channels);
    for (std::size_t p = 0; p < count; ++p) {
        dvec3 rgb;
        for (std::size_t c = 0; c < 3; ++c) {
            const double v =
                std::clamp<double>(image.pixels[p * static_cast<std::size_t>(image.channels) + c], 0.0, 1.0);
            rgb[static_cast<int>(c)] = encoding == Encoding::linear ? v : linear_from_srgb(v);
        }
        const dvec3 o = opponent(rgb);
        for (int c = 0; c < 3; ++c) {
            ycc.c[static_cast<std::size_t>(c)].push_back(o[c]);
        }
    }
    Plane luminance(count);
    for (std::size_t p = 0; p < count; ++p) {
        luminance[p] = (ycc.c[0][p] + 16) / 116;
    }
    Seen seen;
    seen.edges = features(luminance, ycc.width, ycc.height, false, ppd);
    seen.points = features(luminance, ycc.width, ycc.height, true, ppd);
    for (int c = 0; c < 3; ++c) {
        auto& plane = ycc.c[static_cast<std::size_t>(c)];
        plane = contrast_filter(plane, ycc.width, ycc.height, c, ppd);
    }
    for (std::size_t p = 0; p < count; ++p) {
        const dvec3 rgb = rgb_of_opponent({ycc.c[0][p], ycc.c[1][p], ycc.c[2][p]});
        seen.colours.push_back(hunt_lab(glm::clamp(rgb, 0.0, 1.0)));
    }
    return seen;
}

}  // namespace

std::vector<float> flip(const ImageF& image, const ImageF& reference, Encoding encoding,
                        double pixels_per_degree) {
    constexpr double kQc = 0.7, kPc = 0.4, kPt = 0.95, kQf = 0.5;
    const Seen a = see(image, encoding, pixels_per_degree);
    const Seen b = see(reference, encoding, pixels_per_degree);
    const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), kQc);
    const double knee = kPc * largest;
    std::vector<float> out(a.colours.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double raw = std::pow(hyab(a.colours[i], b.colours[i]), kQc);
        const double colour =
            raw < knee ? kPt / knee * raw : kPt + (raw - knee) / (largest - knee) * (1 - kPt);
        const double feature = std::pow(
            std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i])) / std::sqrt(2.0),
            kQf);
        out[i] = static_cast<float>(std::pow(colour, 1 - feature));
    }
    return out;
}

}  // namespace lanthorn::workbench
