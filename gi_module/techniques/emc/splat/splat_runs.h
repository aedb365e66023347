// Dispatches that work off the lists of splats of all tiles, a run of entries each: Mesa's llvmpipe ends an
// invocation's loops, silently, after 65535 turns in all.
#pragma once

#include "gi_module/techniques/emc/splat/splat_tiles.h"

namespace lanthorn::gi {

class SplatRuns {
  public:
    // How many runs the lists of `tiles` need of at most `photons` entries; sums are made by blocks of 8 x 8
    // pixels of a picture of `size`. Does not wait for the GPU.
    void find(SplatTiles& tiles, int photons, ivec2 size);
    // Runs `program`, which reads `first_entry` and `entries`, for each of them.
    void dispatch(const gpu::Program& program) const;

  private:
    gpu::Program program_;
    gpu::Buffer groups_;  // three uint32 a run
    int runs_ = 0;
};

}  // namespace lanthorn::gi
