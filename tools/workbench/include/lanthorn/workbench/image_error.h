// How far a picture of indirect light is from two independent references of it.
#pragma once

#include "lanthorn/core/image.h"

namespace lanthorn::workbench {

// The same light, estimated twice by samples that know nothing of each other: E[(l - a)(l - b)] is the square
// of l's own error, whatever the noise of a and b.
struct ReferencePair {
    ImageF a, b;
};

// Noise of the references taken off; what is lost in it is NaN.
struct ImageError {
    double relrmse = 0;        // RMSE over pixels and channels, over the reference's mean
    double relrmse_sigma = 0;  // its standard error by the references' noise, pixels independent
    double local = 0;          // RMS of (l - r) / sqrt(r^2 + 0.01 mean^2) of luminances
    double local_sigma = 0;    // as relrmse_sigma
    double flux = 0;           // mean over the reference's mean
    double reference_mean = 0;
};

}  // namespace lanthorn::workbench
