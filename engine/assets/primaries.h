// Colours of other primaries than those that pictures have here: of ITU-R BT.709, which sRGB has too.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace lanthorn {

using ColourMatrix = std::array<std::array<double, 3>, 3>;  // rows

// CIE x and y of red, green, blue and white.
using Chromaticities = std::array<double, 8>;

// Takes linear RGB of the primaries to BT.709's, white to white (Bradford; Lam 1985, as in ICC.1:2010, annex
// E). None where they span no triangle around their white point, and where they are BT.709's to the third
// digit, as files round them.
std::optional<ColourMatrix> to_bt709(const Chromaticities& given);

// Takes CIE XYZ, with Y 1 for white, to BT.709; no adaptation.
ColourMatrix bt709_of_xyz();

// "0.64 0.33 0.29 0.6 0.15 0.06 0.3333 0.3333", as Radiance writes them; none of anything else.
std::optional<Chromaticities> chromaticities_of(std::string_view eight_numbers);

// The first three of each `channels` values; of fewer than three there is nothing to do.
void multiply(const ColourMatrix& matrix, std::span<float> pixels, int channels);

}  // namespace lanthorn
