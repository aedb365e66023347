#include "gi_module/techniques/emc/gather/error_model.h"

#include <cmath>

namespace lanthorn::gi {

namespace {

struct Model {
    ErrorTerms weights;
    double low, high;  // of the error over its estimate: a tenth of pictures lies below, a tenth above
};

constexpr Model kRelrmse = {{0.66, 0, 3.21, 5.05, 0.000931, 21.1, 0.000243}, 0.70, 1.28};
constexpr Model kLocal = {{0.937, 0, 2.7, 6.01, 0.837, 15.9, 7.07e-05}, 0.85, 1.22};

EstimatedError error_of(const Model& model, const ErrorTerms& terms) {
    double squared = 0;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        squared += model.weights[i] * terms[i];
    }
    const double value = std::sqrt(squared);
    return {value, model.low * value, model.high * value};
}

}  // namespace

ErrorTerms error_terms(const ErrorParts& parts, double photons, double texels) {
    return {parts.noise,
            parts.blur,
            parts.bend,
            texels > 0 ? parts.contrast / (texels * texels) : 0,
            parts.unknown,
            photons > 0 ? 1 / photons : 0,
            1};
}

void apply_error_model(ErrorEstimate& estimate) {
    estimate.relrmse =
        error_of(kRelrmse, error_terms(estimate.relrmse_parts, estimate.photons, estimate.texels));
    estimate.local = error_of(kLocal, error_terms(estimate.local_parts, estimate.photons, estimate.texels));
}

}  // namespace lanthorn::gi
