#include "engine/assets/primaries.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <string>

namespace lanthorn {

namespace {

using Colour = std::array<double, 3>;

// ITU-R BT.709-6, items 1.3 and 1.4.
constexpr Chromaticities kBt709 = {0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290};
constexpr ColourMatrix kBradford = {
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

Colour product(const ColourMatrix& m, const Colour& v) {
    Colour result = {};
    for (std::size_t row = 0; row < 3; ++row) {
        result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
    }
    return result;
}

ColourMatrix product(const ColourMatrix& a, const ColourMatrix& b) {
    ColourMatrix result = {};
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            for (std::size_t k = 0; k < 3; ++k) {
                result[row][column] += a[row][k] * b[k][column];
            }
        }
    }
    return result;
}

ColourMatrix diagonal(const Colour& d) {
    return {{{d[0], 0, 0}, {0, d[1], 0}, {0, 0, d[2]}}};
}

// By cofactors; not finite where there is none.
ColourMatrix inverse(const ColourMatrix& m) {
    ColourMatrix result = {};
    double determinant = 0;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            const std::size_t r1 = (row + 1) % 3, r2 = (row + 2) % 3;
            const std::size_t c1 = (column + 1) % 3, c2 = (column + 2) % 3;
            result[column][row] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
        }
        determinant +=
            row == 0 ? m[0][0] * result[0][0] + m[0][1] * result[1][0] + m[0][2] * result[2][0] : 0;
    }
    for (auto& row : result) {
        for (double& value : row) {
            value /= determinant;
        }
    }
    return result;
}

// Of luminance 1.
Colour xyz_of(double x, double y) {
    return {x / y, 1, (1 - x - y) / y};
}

// Columns are what the primaries are in XYZ, which sum up to white (SMPTE RP 177-1993, 3.3).
ColourMatrix xyz_of_rgb(const Chromaticities& c) {
    ColourMatrix columns = {};
    for (std::size_t i = 0; i < 3; ++i) {
        const Colour primary = {c[2 * i], c[2 * i + 1], 1 - c[2 * i] - c[2 * i + 1]};
        for (std::size_t row = 0; row < 3; ++row) {
            columns[row][i] = primary[row];
        }
    }
    return product(columns, diagonal(product(inverse(columns), xyz_of(c[6], c[7]))));
}

bool is_sound(const Chromaticities& c) {
    const auto side = [&](std::size_t a, std::size_t b) {  // on which of the line from a to b white lies
        return (c[2 * b] - c[2 * a]) * (c[7] - c[2 * a + 1]) -
               (c[2 * b + 1] - c[2 * a + 1]) * (c[6] - c[2 * a]);
    };
    constexpr double kThin = 1e-4;
    const double least = std::min({side(0, 1), side(1, 2), side(2, 0)});
    const double most = std::max({side(0, 1), side(1, 2), side(2, 0)});
    return std::ranges::all_of(c, [](double v) { return std::abs(v) <= 10; }) && c[7] > kThin &&
           (least > kThin || most < -kThin);
}

}  // namespace

std::optional<ColourMatrix> to_bt709(const Chromaticities& given) {
    if (!is_sound(given) ||
        std::ranges::equal(given, kBt709, [](double a, double b) { return std::abs(a - b) < 2e-3; })) {
        return std::nullopt;
    }
    const Colour from = product(kBradford, xyz_of(given[6], given[7]));
    const Colour to = product(kBradford, xyz_of(kBt709[6], kBt709[7]));
    const ColourMatrix adapted =
        product(inverse(kBradford),
                product(diagonal({to[0] / from[0], to[1] / from[1], to[2] / from[2]}), kBradford));
    return product(bt709_of_xyz(), product(adapted, xyz_of_rgb(given)));
}

ColourMatrix bt709_of_xyz() {
    return inverse(xyz_of_rgb(kBt709));
}

std::optional<Chromaticities> chromaticities_of(std::string_view eight_numbers) {
    const std::string text(eight_numbers);
    const char* at = text.c_str();
    Chromaticities result = {};
    for (double& number : result) {
        char* end = nullptr;
        number = std::strtod(at, &end);
        if (end == at) {
            return std::nullopt;
        }
        at = end;
    }
    return result;
}

void multiply(const ColourMatrix& matrix, std::span<float> pixels, int channels) {
    const auto step = static_cast<std::size_t>(channels);
    for (std::size_t i = 0; channels >= 3 && i + step <= pixels.size(); i += step) {
        const Colour colour = product(matrix, Colour{pixels[i], pixels[i + 1], pixels[i + 2]});
        for (std::size_t c = 0; c < 3; ++c) {
            pixels[i + c] = static_cast<float>(colour[c]);
        }
    }
}

}  // namespace lanthorn
