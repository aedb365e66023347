// What `lanthorn trade` is asked to measure.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/workbench/trade_measure.h"
#include "lanthorn/workbench/trade_point.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/replay_suite/farm_tasks.h"

namespace lanthorn::tools {

struct TradeOptions {
    Sweep sweep;
    std::vector<std::string> knobs;  // for sweep.knobs, as typed
    std::string output, size = "512x512";
    TradeMeasurement job;
    int reference_spp = 256;
    int thumbnail = 96;  // pixels, width
    int seeds = 1;
    suite::FarmChoice farm{"", 1, {}};  // executor empty and one job: here, one after the other

    bool by_others() const { return !farm.executor.empty() || farm.jobs > 1; }
};

// "KEY=VALUE" of `options` that hold for the references too: those of the path tracer that say what light
// does at surfaces, not how many samples are taken nor when it ends.
std::vector<std::string> of_references(const TradeOptions& options);

}  // namespace lanthorn::tools
