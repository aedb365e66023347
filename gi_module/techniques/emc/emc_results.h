// What a frame turned out to do that its plan could not know: to be printed, and for later passes.
#pragma once

#include <optional>

#include "gi_module/techniques/emc/splat/splat_ways.h"

namespace lanthorn::gi {

struct EmcResults {
    int maps = 0;            // 0: not known yet
    int faces = 0;           // of maps that were drawn
    bool exchanged = false;  // a map was, and drawn
    bool fading = false;     // from a map to the one in its place, in the next frame, too
    bool no_map = false;     // no candidate sees anything: nothing is traced or gathered
    // Whether rays travel through triangles instead of maps (gi.emc.rays); known once they have been shot.
    std::optional<bool> exact_rays;
    // How splats are summed, and how photons find their tiles: chosen by measuring; known once splatted.
    std::optional<SplatKernel> splat_kernel;
    std::optional<SplatBinning> splat_binning;
};

}  // namespace lanthorn::gi
