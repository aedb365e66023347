// The final gather: irradiance over the picture from rays that meet lit maps, at the points of a coarse grid,
// with remembered hits; filtered over surfaces and up-sampled.
#pragma once

#include <optional>

#include "gi_module/techniques/emc/gather/gather_error.h"
#include "gi_module/techniques/emc/gather/gather_filter.h"
#include "gi_module/techniques/emc/gather/gather_links.h"
#include "gi_module/techniques/emc/gather/gather_upsampling.h"
#include "gi_module/techniques/emc/gather/gather_work.h"
#include "gi_module/techniques/emc/gather/near_pixels.h"
#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "gi_module/techniques/emc/gather/surface_points.h"
#include "gi_module/techniques/emc/lit_maps/lit_maps.h"
#include "gi_module/techniques/emc/maps/unseen_places.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class Gather {
  public:
    // `closely`: exact rays' hits beside lamps and corners, and pixels beside lamps, are lit one by one
    // (close_hits.h); of all gathers one may do so. Else lit texels light all hits.
    explicit Gather(bool closely = true) : closely_(closely) {}

    // Irradiance in lux over the G-buffer's pixels.
    const gpu::Texture& irradiance(const render::FrameInputs& inputs, const EnvironmentMaps& maps,
                                   LitMaps& lit, const SweptBoxes& movers, ExactRays* exact,
                                   const GiSettings& settings, const GatherWork& work,
                                   const gpu::Buffer& bad_values);

    const gpu::Texture& picture() const { return upsampling_.picture(); }  // of the last irradiance()
    int frames() const { return frames_; }  // of rays since the points last changed
    UnseenPlaces& unseen() { return unseen_; }
    // Rays of the last frame that shot any; waits for the GPU.
    std::uint64_t rays() const { return hits_.shot(); }
    // By point of the grid, for inspection; wait for the GPU. Rays behind it; what these gather, lux.
    std::vector<vec4> known() const;
    std::vector<vec4> unfiltered(const LitMaps& lit);
    // Of the last irradiance(), the lit maps as they were for it; waits for the GPU if nobody has asked
    // before.
    const GatherError::Parts& error_parts(const LitMaps& lit);
    ivec2 grid() const { return grid_; }
    int stride() const { return stride_; }  // pixels
    // Rays behind the picture; waits for the GPU.
    std::uint64_t remembered() const;

  private:
    void allocate(ivec2 size, const GiSettings& settings);
    void place(const render::FrameInputs& inputs);
    const gpu::Buffer& filter(const gpu::Buffer& irradiance);
    GatherFilter::Points filtered_points(const gpu::Buffer& irradiance) const {
        return {grid_, points_.points(), irradiance, hits_.known(), links_.cuts()};
    }

    bool closely_;
    ivec2 size_{0};
    int stride_ = 0;
    ivec2 grid_{0};
    SurfacePoints points_;
    RememberedHits hits_{RememberedHits::Of::picture};
    CloseHits close_{CloseHits::kSlots};
    NearPixels near_;
    GatherUpsampling upsampling_;
    int frames_ = 0;
    // Surfaces have moved since the view last changed. Rays that a camera has gathered on its way are spread
    // less evenly than their number tells.
    bool by_rays_ = false;
    GatherLinks links_;
    GatherFilter filter_;
    const gpu::Buffer* filtered_ = nullptr;  // of the last irradiance()
    GatherError error_;
    std::optional<GatherError::Parts> error_parts_;  // the same, once somebody has asked
    UnseenPlaces unseen_;
    gpu::Program points_program_;
};

}  // namespace lanthorn::gi
