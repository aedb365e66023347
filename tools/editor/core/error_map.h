// How far the indirect light of a picture lies off the path tracer's, by places of the picture, and in one
// figure with its uncertainty.
#pragma once

#include <functional>
#include <vector>

#include "gi_module/reference/sparse_paths.h"
#include "lanthorn/core/image.h"

namespace lanthorn::editor {

struct ErrorMap {
    ivec2 cells{0};
    int stride = 1;  // pixels of a cell's side
    ivec2 size{0};   // of the picture
    // By cell: (picture - reference) / sqrt(reference^2 + 0.01 mean^2), luminance, as `local error` has it; 0
    // where it lies within the reference's noise (two standard errors), NaN where nothing is seen that light
    // is gathered on.
    std::vector<float> error;
    // The picture's relRMSE of indirect irradiance, as `lanthorn compare` measures it: by the cells' pixels,
    // without the reference's noise.
    double relative = 0;
    double uncertainty = 0;     // one standard error of it
    bool within_noise = false;  // it is no more than `relative + 2 uncertainty`, and may be none at all
    int spp = 0;                // of the reference
};

inline constexpr int kErrorStride = 4;

// Of `indirect` (lux, three channels, rows from the top) against what has been traced so far for a picture of
// that size; at least four samples a cell.
ErrorMap error_map(const reference::SparsePaths& paths, const ImageF& indirect);

}  // namespace lanthorn::editor
