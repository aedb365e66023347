// Irradiance at points that are not on the picture: what mirrors and glass show. They are put together as
// a picture of their own, near ones side by side, and splatted as that; with the first bandwidth alone, since
// the oracle compares neighbours along the picture's axes.
#pragma once

#include <span>
#include <vector>

#include "gi_module/techniques/splat/photon_splats.h"

namespace lanthorn::gi {

class PointSplats {
  public:
    // By point, lux; 0 where there is no surface (kNoSide). False where photons could not be read:
    // photons.store().error() says why. Waits for the GPU. O(n log n + n * C^2 + photons).
    bool light(std::span<const PixelSurface> points, const SplatSurfaces& surfaces, PhotonCollection& photons,
               std::span<const vec3> powers, const SplatSettings& settings, reference::TileWorkers& workers,
               std::vector<vec4>& irradiances);
    std::uint64_t bad() const { return bad_; }  // values that were not numbers so far

  private:
    PictureSurfaces picture_;
    PhotonSplats splats_;
    std::uint64_t bad_ = 0;
};

// Where each point goes in such a picture, into its pixels, and how large that is. Points without a surface
// have none. The same in whatever order they come. Pure, no GL. O(n log n).
inline constexpr std::uint32_t kNoPixel = 0xffffffffu;
struct PointPicture {
    ivec2 size{0};
    std::vector<std::uint32_t> pixels;  // by point; or kNoPixel
};
PointPicture point_picture(std::span<const PixelSurface> points);

}  // namespace lanthorn::gi
