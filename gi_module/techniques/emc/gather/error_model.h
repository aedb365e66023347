// From what is seen of a gathered picture's error to the error: a sum of squares with few weights, fitted to
// pictures whose error is known (`lanthorn measure estimate --fit`, docs/error-estimate.md).
#pragma once

#include <array>

#include "lanthorn/gi/statistics.h"

namespace lanthorn::gi {

// What weights there are for, of one figure: noise, blur, bend, contrast over texels^2, unknown, 1 / photons,
// and 1: what every picture lacks.
inline constexpr int kErrorTerms = 7;
using ErrorTerms = std::array<double, kErrorTerms>;

ErrorTerms error_terms(const ErrorParts& parts, double photons, double texels);

// relrmse and local of `estimate` by its parts.
void apply_error_model(ErrorEstimate& estimate);

}  // namespace lanthorn::gi
