// The work of a sweep: points that are finished are kept, the others are measured one after the other.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "lanthorn/workbench/trade_point.h"
#include "tools/lanthorn/common/child_process.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

// Measures `point` and writes `stem`.json (figures_json) and `stem`.png, the JSON last. May crash: what
// became of it is the return value.
using PointRunner = std::function<ChildOutcome(const TradePoint& point, const std::filesystem::path& stem)>;

// Whether a point has left both.
bool is_finished(const std::filesystem::path& stem);

struct TradeRun {
    std::vector<TradeResult> results;  // one a point, in order; fewer if it was interrupted
    std::size_t kept = 0;              // of them, finished before this run
    std::size_t lost = 0;              // of them, without figures
    bool interrupted = false;
};

// `stems`: one a point, the same only for the same measurement. `progressed` is told the number of points
// done, `stop` asked before each. A point that fails is lost alone; a missing OpenGL (exit code 3) ends the
// run with Error, a folder that cannot be written with InputError.
TradeRun run_points(const std::vector<TradePoint>& points, const std::vector<std::filesystem::path>& stems,
                    const PointRunner& runner, const std::function<void(std::size_t)>& progressed,
                    const std::function<bool()>& stop);

}  // namespace lanthorn::tools
