// What to set for a time or an error, from the points of a chart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/lanthorn/trade/chart_rows.h"

namespace lanthorn::tools {

// What a wish is about.
enum class Budget {
    ms,     // no frame's indirect light costs more milliseconds
    error,  // no picture's relRMSE is larger
};

// A way in all scenes of a chart.
struct WayFigures {
    Way way;
    double ms = 0, error = 0;  // geometric means over the scenes: each scene counts by ratios
    double most_ms = 0, most_error = 0;
    std::string slowest, worst;     // the scenes of those two
    double gpu_mb = 0, rss_mb = 0;  // the largest of a scene; 0: the chart does not say
};

struct Advice {
    double limit = 0;
    // Of the ways that keep within the limit in enough scenes, the one that has least of the other: error
    // for milliseconds, milliseconds for an error. None where no way does.
    std::optional<WayFigures> best;
    WayFigures nearest;  // the way that would keep within the smallest limit, and
    double least = 0;    // that limit
};

// Whether any way was measured in every scene of `rows`.
bool has_common_way(const std::vector<ChartRow>& rows);

// For a limit above 0 that holds in at least `share` (above 0, at most 1) of the scenes, among the ways that
// were measured in every scene; the first of equals. Throws InputError without any.
Advice advise(const std::vector<ChartRow>& rows, Budget budget, double limit, double share = 1);

// The rows of those scenes alone. Throws InputError for a name that the chart does not have.
std::vector<ChartRow> of_scenes(const std::vector<ChartRow>& rows, const std::vector<std::string>& scenes);

// In the order of their first row.
std::vector<std::string> scenes_of(const std::vector<ChartRow>& rows);

}  // namespace lanthorn::tools
