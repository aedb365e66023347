#pragma once

#include <string>

#include "lanthorn/workbench/render_job.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

// What --stats writes: indented JSON; the keys are those of the manual.
std::string stats_json(const RenderOutcome& outcome, const RenderJob& job, const Settings& settings,
                       const std::string& preset, double load_ms);

// What --trace writes: every pass of every frame in the trace event format that chrome://tracing and Perfetto
// read.
std::string trace_json(const RenderOutcome& outcome);

}  // namespace lanthorn::tools
