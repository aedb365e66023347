// What rays from the picture have met that no lit texel shows: where maps are missing. A sample a tile of the
// gather's grid is found on the GPU and read in the next frame.
#pragma once

#include <vector>

#include "engine/gpu/read_back.h"
#include "gi_module/techniques/emc/gather/remembered_hits.h"
#include "gi_module/techniques/emc/lit_maps/lit_texels.h"
#include "gi_module/techniques/emc/maps/environment_maps.h"
#include "gi_module/techniques/emc/maps/unseen_survey.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"

namespace lanthorn::gi {

class UnseenPlaces {
  public:
    // Compiles and allocates what find() needs, so that the first does neither in a frame of a still picture.
    void prepare();
    // Of all rays that are remembered. Cost: a fetch a ray.
    void find(RememberedHits& hits, ivec2 grid, const RayScene& rays);
    bool found() const { return found_; }  // and not taken
    void forget();
    // What the last find() has found. Waits at most for what the GPU had to do until then.
    UnseenSurvey take();

  private:
    gpu::Program program_;
    gpu::Buffer tiles_;
    gpu::ReadBack found_tiles_;
    bool found_ = false;
    gpu::BufferTexture lit_points_view_;
};

}  // namespace lanthorn::gi
