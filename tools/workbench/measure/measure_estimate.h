// What a picture's error is estimated to be without a reference, beside what it is by one, in scenes at rest
// and in motion; and the weights by which one becomes the other.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "gi_module/techniques/emc/gather/error_model.h"
#include "lanthorn/workbench/measure_motions.h"

namespace lanthorn::workbench {

struct EstimatePoint {
    std::string scene, of;       // the case's name
    std::string motion;          // "first": the first frame of `rest`
    bool held = false;           // of a scene that the weights were not fitted to
    gi::ErrorEstimate estimate;  // known
    ImageError truth;            // noise of the references taken off
    double estimate_ms =
        0;             // processor time that the estimate took; none of a first frame, where it is known
    double gi_ms = 0;  // the same of the frame's indirect light
};

// Both of the two figures that are estimated.
enum class EstimatedFigure { relrmse, local };
double estimated(const EstimatePoint& point, EstimatedFigure figure);
double true_error(const EstimatePoint& point, EstimatedFigure figure);

// One or two points a motion of the job for each case: `rest` gives the first frame and the last one. Motions
// that a scene lacks, frames without an estimate and pictures whose error is lost in the references' noise
// are left out. Throws as measure_motions(). `done` is called for each motion of each case.
std::vector<EstimatePoint> measure_estimates(const MotionScene& scene, const std::vector<MotionCase>& cases,
                                             const MotionJob& job, ReferencePairs& references,
                                             const std::function<void()>& done);

// What share of the points has an estimate within `factor` of the truth, either way; 0 where there are none.
double share_within(const std::vector<EstimatePoint>& points, EstimatedFigure figure, double factor);

struct EstimateFit {
    gi::ErrorTerms weights{};
    double low = 0, high = 0;  // of the truth over the estimate: the tenth and the ninetieth percentile
};
// The weights with the least mean square of ln(estimate / truth) over the points that are not held. Each
// scene counts alike. O(points), some thousand times.
EstimateFit fit_estimates(const std::vector<EstimatePoint>& points, EstimatedFigure figure);

}  // namespace lanthorn::workbench
