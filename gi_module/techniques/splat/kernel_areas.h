// What a pixel's kernel integrates to over the surface that it shows: the sum of its photons' power over this
// is irradiance (Lavignotte and Paulin 2003, eq. 5 and sec. 4.1).
#pragma once

#include <span>
#include <vector>

#include "gi_module/techniques/splat/picture_surfaces.h"
#include "gi_module/techniques/splat/splat_settings.h"

namespace lanthorn::gi {

// By pixel, one over the integral in m^2; 0 where there is no kernel. `bandwidths`: h by side, metres; 0:
// none. With `boundaries` over the surface that lies within h, else over a whole disc. Where it hardly
// changes from one fourth pixel to the next (2 %) it is interpolated, else exact; exact everywhere where
// the picture's pixels are scattered. O(pixels).
std::vector<float> inverse_kernel_areas(const PictureSurfaces& picture, const SplatSurfaces& surfaces,
                                        std::span<const float> bandwidths, PhotonKernel kernel,
                                        bool boundaries, std::span<const std::uint32_t> open,
                                        reference::TileWorkers& workers);

// The same of one point, of bandwidth `h` in metres; 0 where that is 0. O(log triangles + triangles cut).
float inverse_kernel_area(const PixelSurface& pixel, const SplatSurfaces& surfaces, float h,
                          PhotonKernel kernel, bool boundaries);

// h = C sqrt(A / N) by side (sec. 3.3), from the number of photons on each; 0 where there are none. No larger
// than what covers the surface from anywhere on it.
std::vector<float> bandwidths(const SplatSurfaces& surfaces, std::span<const std::uint64_t> photons, float c);

}  // namespace lanthorn::gi
