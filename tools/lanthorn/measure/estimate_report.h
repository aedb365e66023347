// What `lanthorn measure estimate` tells of estimated and true errors.
#pragma once

#include <string>
#include <vector>

#include "tools/lanthorn/common/workbench.h"
#include "tools/workbench/measure/measure_estimate.h"

namespace lanthorn::tools {

// A line a point, numbers with six digits.
std::string estimate_csv(const std::vector<EstimatePoint>& points);
// Estimate against truth for both figures, logarithmic: scenes that the weights were fitted to and others in
// two colours, pictures at rest filled and in motion hollow, by preset's shape; the band is 1.5 times, either
// way.
std::string estimate_svg(const std::vector<EstimatePoint>& points);
// How many are how near, fitted and held scenes, at rest and in motion, and what the estimate costs.
std::string estimate_table(const std::vector<EstimatePoint>& points);
// What error_model.cpp wants.
std::string fit_text(const std::vector<EstimatePoint>& points);

}  // namespace lanthorn::tools
