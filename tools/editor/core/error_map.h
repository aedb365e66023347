// How far the indirect light of a picture lies off the path tracer's, by places of the picture, and in one
// figure with its uncertainty.
#pragma once

#include <vector>

#include "gi_module/reference/sparse_paths.h"
#include "lanthorn/core/image.h"

namespace lanthorn::editor {

struct ErrorMap {
    ivec2 cells{0};
    int stride = 1;  // pixels of a cell's side
    ivec2 size{0};   // of the picture
    // By cell, of it and its neighbours together: (picture - reference) / sqrt(reference^2 + 0.01 mean^2),
    // luminance; 0 where that lies within the reference's noise, NaN where nothing is seen that light is
    // gathered on.
    std::vector<float> error;
    // The `local error` of the picture: the root of the mean square of that, of each place alone, and without
    // the reference's noise. It judges dark parts as well as bright ones.
    double local = 0;
    double uncertainty = 0;  // one standard error of it
    bool within_noise =
        false;    // it is no more than `local` and twice `uncertainty` together, and may be none at all
    int spp = 0;  // of the reference
};

inline constexpr int kErrorStride = 4;

// Of `indirect` (lux, three channels, rows from the top) against what has been traced so far for a picture of
// that size; at least four samples a cell.
ErrorMap error_map(const reference::SparsePaths& paths, const ImageF& indirect);

}  // namespace lanthorn::editor
