// A still picture by the final gather, as the mean of ever more rays: each pass shoots new directions from
// other pixels, so that neither the grid of points nor the directions that are remembered limit how right it
// becomes; and what an exact ray meets has direct light of its own, so that lit texels do not either. What a
// picture in motion needs (gather.h) is left as it is: when something changes, that one goes on where it was.
#pragma once

#include "gi_module/techniques/emc/gather/close_hits.h"
#include "gi_module/techniques/emc/gather/gather_filter.h"
#include "gi_module/techniques/emc/gather/gather_links.h"
#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "gi_module/techniques/emc/lit_maps/lit_maps.h"
#include "lanthorn/gi/statistics.h"
#include "lanthorn/gpu/texture.h"
#include "lanthorn/render/frame.h"

namespace lanthorn::gi {

class StillGather {
  public:
    // Pass `pass` of at most `last`, from 1 on: gi.gather.rays rays from one pixel in each cell of
    // gi.gather.grid. Returns irradiance in lux, which begins as `first`, the gathered picture, and
    // approaches the mean of the rays alone.
    // Exact rays take direct light where they end, and of lit texels what these have reflected more often.
    // Cost: rays as a frame of the gather's (fewer where their ends would not fit into CloseHits), and with
    // such a pass the filter over all pixels. 68 bytes a pixel.
    const gpu::Texture& irradiance(const render::FrameInputs& inputs, const RayScene& rays, LitMaps& lit,
                                   const gpu::Texture& first, int pass, int last,
                                   const gpu::Buffer& bad_values);

    // The gathered picture after light alone has changed, the view and surfaces as they were: in the first
    // frames less and less as much off as the passes have found it to be before, so that nothing jumps. What
    // its rays bring is shaded otherwise, but they are the same rays, and wrong in about the same way.
    const gpu::Texture& faded(const gpu::Texture& gathered);
    // Another view, or other surfaces: nothing is left to fade.
    void end_fade() { fade_left_ = 0; }

    // Whether the picture is another after that pass: after every fourth of the first, later after every few
    // per cent more of them, and after the last.
    static bool changes_picture(int pass, int last);

    // What is known of the gathered picture's error, as it is of the last picture.
    void refine(ErrorParts& parts) const;

  private:
    void begin(const render::FrameInputs& inputs, const RayScene& rays);
    void place(const render::FrameInputs& inputs, int pass);
    // Irradiance at the pass's points.
    const gpu::Buffer& shoot(const render::FrameInputs& inputs, const RayScene& rays, LitMaps& lit, int pass,
                             const gpu::Buffer& bad_values);
    void add(const gpu::Buffer& irradiance);
    void show(const gpu::Texture& first, double rays);

    ivec2 size_{0};
    int stride_ = 0;
    ivec2 grid_{0};
    ivec2 offset_{0};       // of this pass's pixels in their cells
    SurfacePoints points_;  // of this pass
    RememberedHits hits_{RememberedHits::Of::still_picture};
    CloseHits close_{CloseHits::kStillSlots, CloseHits::Of::every_hit};
    GatherLinks links_;  // between pixels
    GatherFilter filter_;
    gpu::Program surfaces_program_, points_program_, mean_program_, show_program_, fade_program_;
    // By pixel.
    gpu::Buffer surfaces_;  // vec4: packed points
    gpu::Buffer mean_;      // vec4: of all rays so far, lux; a: mean square luminance, < 0: none
    gpu::Buffer known_;     // float: how many these are
    gpu::Texture picture_;
    gpu::Texture corrections_;  // of the last picture over the gathered one, by pixel and channel
    int fade_left_ = 0;         // frames
    double shown_rays_ = 0;     // of a pixel, behind it
    bool exact_ = false;        // they take direct light where they end
    gpu::BufferTexture irradiance_view_, rays_view_;
};

}  // namespace lanthorn::gi
