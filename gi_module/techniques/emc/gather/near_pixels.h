// Pixels beside lamps that the gather's grid is too coarse for: a lantern's bars, a hand that holds it. Each
// shoots its own rays, into what close hits reflect (close_hits.h), and takes the mean over its neighbours on
// the same surface.
#pragma once

#include <span>

#include "gi_module/techniques/emc/gather/close_hits.h"
#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "gi_module/techniques/emc/lit_maps/lit_maps.h"

namespace lanthorn::gi {

class NearPixels {
  public:
    // Of another view or other surfaces: which pixels they are, and their rays. `points`: of the grid. Waits
    // for the GPU. Cost: a look at a few hundred pixels around each of the lamps in view, and kRays rays for
    // each that is found, at most kMost.
    void shoot(const render::FrameInputs& inputs, const RayScene& rays, LitMaps& lit,
               const SurfacePoints& points, ivec2 grid, int stride);
    // Into the picture, as light falls now.
    void show(const render::FrameInputs& inputs, const RayScene& rays, LitMaps& lit,
              const gpu::Texture& picture, const gpu::Buffer& bad_values);
    void forget() { count_ = 0; }
    int count() const { return count_; }

  private:
    static constexpr int kMost = 256;
    static constexpr int kRays = 64;

    void build_programs();
    // Squares of pixels around the lamps that the camera sees, as near_select.comp has them.
    std::vector<vec4> squares(const render::FrameInputs& inputs, int side) const;

    int count_ = 0;
    CloseHits close_{CloseHits::kPixelSlots};
    RememberedHits hits_{RememberedHits::Of::still_picture};
    SurfacePoints points_;
    EntryList found_;
    gpu::Buffer squares_, pixels_;
    gpu::Program select_, place_, show_;
    gpu::BufferTexture squares_view_, lamps_view_, grid_view_, pixels_view_, points_view_, irradiance_view_;
};

}  // namespace lanthorn::gi
