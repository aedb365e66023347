// Cube maps, and irradiance as spherical harmonics, as skies: what EXT_lights_image_based holds.
#pragma once

#include <array>
#include <vector>

#include "lanthorn/scene/sky.h"

namespace lanthorn {

// Radiance on the six faces of a cube around the origin, towards +X, -X, +Y, -Y, +Z, -Z. Each is what is seen
// from inside, not mirrored, by rows from the top left: the top of the four sides is +Y, that of +Y is -Z,
// that of -Y is +Z.
struct SkyCube {
    std::uint32_t size = 0;                  // pixels a side
    std::array<std::vector<vec3>, 6> faces;  // size * size each; nits, finite, >= 0

    // From a unit direction, bilinear within the face.
    vec3 radiance(const vec3& direction) const;
};

// The cube as an equirectangular image, 4 by 2 times as many pixels as a face's side, at most 8192 x 4096. Of
// each channel the same flux. O(pixels).
SkyImage sky_of_cube(const SkyCube& cube);

// Coefficients of irradiance, in lux, in the order of Ramamoorthi and Hanrahan 2001 ('An Efficient
// Representation for Irradiance Environment Maps'): Y00, Y1-1, Y10, Y11, Y2-2, Y2-1, Y20, Y21, Y22.
using IrradianceHarmonics = std::array<vec3, 9>;

// The smoothest sky that lights surfaces so: radiance up to the second band. Where that is negative it is
// black, and the rest is scaled so that the flux stays; black altogether if the flux is not positive.
SkyImage sky_of_harmonics(const IrradianceHarmonics& irradiance);

}  // namespace lanthorn
