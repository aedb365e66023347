#include "tools/lanthorn/replay/pictures/picture_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lanthorn/core/error.h"

namespace lanthorn::tools {

namespace {

constexpr double kSure = 0.01, kMatters = 0.005;
// Figures are compared relative to at least so much: a share of the picture's mean light, a step of 8 bits.
constexpr double kDark = 0.01, kFlat = 1.0 / 255;

double luminance(const ImageF& image, int x, int y) {
    return 0.2126 * image.at(x, y, 0) + 0.7152 * image.at(x, y, 1) + 0.0722 * image.at(x, y, 2);
}

int tiles_across(int pixels) {
    return (pixels + kTilePixels - 1) / kTilePixels;
}

// visit(x0, y0, x1, y1), row by row from the top.
template <class Visit>
void for_each_tile(const ImageF& image, const Visit& visit) {
    for (int y0 = 0; y0 < image.height; y0 += kTilePixels) {
        for (int x0 = 0; x0 < image.width; x0 += kTilePixels) {
            visit(x0, y0, std::min(x0 + kTilePixels, image.width), std::min(y0 + kTilePixels, image.height));
        }
    }
}

double mean_of(const std::vector<double>& values) {
    return values.empty()
               ? 0
               : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Differences of one figure, a seed each, relative to what was before.
class Paired {
  public:
    void add(double before, double now, double least) {
        const double scale = std::max(before, least);
        values_.push_back(scale > 0 ? (now - before) / scale : now > 0 ? 1 : 0);
    }
    double mean() const { return mean_of(values_); }
    // Student's paired test of "no change".
    double p() const {
        const double m = mean(), n = static_cast<double>(values_.size());
        double square = 0;
        for (const double v : values_) {
            square += (v - m) * (v - m);
        }
        const double error = std::sqrt(square / (n * (n - 1)));
        return m == 0 ? 1 : error > 0 ? student_p4(m / error) : 0;
    }

  private:
    std::vector<double> values_;
};

}  // namespace

double PictureFigures::mean_light() const {
    return mean_of(light);
}

PictureFigures picture_figures(const ImageF& shown, const ImageF& radiance) {
    PictureFigures figures{tiles_across(shown.width), light_of_tiles(radiance), {}};
    for_each_tile(shown, [&](int x0, int y0, int x1, int y1) {
        double detail = 0;
        int steps = 0;
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x + 1 < x1; ++x) {
                detail += std::abs(luminance(shown, x + 1, y) - luminance(shown, x, y));
                ++steps;
            }
        }
        figures.detail.push_back(steps > 0 ? detail / steps : 0);
    });
    return figures;
}

std::vector<double> light_of_tiles(const ImageF& radiance) {
    std::vector<double> tiles;
    for_each_tile(radiance, [&](int x0, int y0, int x1, int y1) {
        double light = 0;
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) {
                light += luminance(radiance, x, y);
            }
        }
        tiles.push_back(light / ((x1 - x0) * (y1 - y0)));
    });
    return tiles;
}

FigureDifference direct_difference(const std::vector<double>& before, const std::vector<double>& now,
                                   int columns, const std::string& what) {
    if (before.size() != now.size()) {
        throw InputError(what, "direct",
                         fmt::format("found {} tiles, expected {}", before.size(), now.size()));
    }
    FigureDifference largest;
    const double least = kDark * mean_of(before);
    for (std::size_t i = 0; i < now.size(); ++i) {
        Paired pair;
        pair.add(before[i], now[i], least);
        const double change = pair.mean();
        if (std::abs(change) > std::abs(largest.change)) {
            largest = {"direct light", static_cast<int>(i) % columns, static_cast<int>(i) / columns, change,
                       0};
        }
    }
    return largest;
}

double student_p4(double t) {
    // Abramowitz and Stegun 1964, 26.7.4, for 4 degrees of freedom: A = sin(theta)(1 + cos^2(theta) / 2) with
    // tan(theta) = t / 2; p = 1 - A = (1 - s)^2 (2 + s) / 2, which keeps its digits where s is about 1.
    const double s = std::abs(t) / std::sqrt(4 + t * t);
    const double rest = 4 / ((4 + t * t) * (1 + s));  // 1 - s
    return std::isfinite(t) ? rest * rest * (2 + s) / 2 : 0;
}

FigureDifference sure_difference(const std::vector<PictureFigures>& before,
                                 const std::vector<PictureFigures>& now, const std::string& what) {
    if (before.size() != static_cast<std::size_t>(kSeeds) || now.size() != before.size()) {
        throw InputError(what, "seeds", fmt::format("found {}, expected {}", before.size(), kSeeds));
    }
    const std::size_t tiles = now[0].light.size();
    for (const PictureFigures& one : before) {
        if (one.light.size() != tiles || one.detail.size() != tiles) {
            throw InputError(what, "tiles", fmt::format("found {}, expected {}", one.light.size(), tiles));
        }
    }
    const double tests = static_cast<double>(2 * tiles + 1);
    FigureDifference largest;
    const auto test = [&](const char* figure, int x, int y, const Paired& paired) {
        const double p = paired.p() * tests, change = paired.mean();
        if (p < kSure && std::abs(change) > kMatters && std::abs(change) > std::abs(largest.change)) {
            largest = {figure, x, y, change, p};
        }
    };
    Paired whole;
    for (int k = 0; k < kSeeds; ++k) {
        whole.add(before[k].mean_light(), now[k].mean_light(), 0);
    }
    test("light", -1, -1, whole);
    for (std::size_t i = 0; i < tiles; ++i) {
        Paired light, detail;
        for (int k = 0; k < kSeeds; ++k) {
            light.add(before[k].light[i], now[k].light[i], kDark * before[k].mean_light());
            detail.add(before[k].detail[i], now[k].detail[i], kFlat);
        }
        const int x = static_cast<int>(i) % now[0].columns, y = static_cast<int>(i) / now[0].columns;
        test("light", x, y, light);
        test("detail", x, y, detail);
    }
    return largest;
}

}  // namespace lanthorn::tools
