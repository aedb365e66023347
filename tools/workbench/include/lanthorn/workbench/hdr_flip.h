#pragma once

#include <vector>

#include "lanthorn/workbench/flip.h"

namespace lanthorn::workbench {

// The exposures, in stops, that HDR-FLIP looks at: from where the reference's brightest pixel comes out at
// 0.85 of white to where its median does, about a stop apart.
struct Exposures {
    double start = 0, stop = 0;
    int count = 0;

    // The exposure `i` of 0..count - 1, stops; evenly spaced.
    double at(int i) const { return count > 1 ? start + (stop - start) * i / (count - 1) : start; }
};

// Andersson et al. 2021, "Visualizing Errors in Rendered High Dynamic Range Images", sec. 3.1, with their
// tone mapper (Narkowicz 2016, "ACES Filmic Tone Mapping Curve"). Unlike theirs, the median is that of the
// pixels that are not black, so that a background does not ask for endless exposures.
Exposures flip_exposures(const ImageF& reference);

// HDR-FLIP (the same, sec. 3): by pixel the largest LDR-FLIP of all exposures, 0 (nothing) to 1. Both: equal
// sizes, at least three channels (the first three count), linear; negative values count as 0. Costs flip()
// for each exposure.
std::vector<float> hdr_flip(const ImageF& image, const ImageF& reference,
                            double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace lanthorn::workbench
