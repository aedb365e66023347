// What `lanthorn trade` has done by processes of its own: one that crashes takes no other with it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lanthorn/core/stop_signal.h"
#include "tools/lanthorn/common/child_process.h"
#include "tools/lanthorn/trade/trade_folder.h"

namespace lanthorn::tools {

// As run_child(), for this program: its errors without the name that they start with.
ChildOutcome run_own(const std::vector<std::string>& arguments);

// Traces a reference unless it is there. An interrupted one is not kept. Throws Error with the code of a
// tracer that fails.
void make_reference(const TradeFolder& folder, const TradeOptions& options, const std::string& scene,
                    TradeMotion motion, int bounces, const StopSignal& stop);

// The arguments of the process that measures a point.
std::vector<std::string> point_command(const TradePoint& point, const TradeOptions& options,
                                       const TradeReferences& references, const std::filesystem::path& stem);

}  // namespace lanthorn::tools
