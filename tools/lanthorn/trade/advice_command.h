// The half of `lanthorn trade` that measures nothing: what to set, by a chart.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "lanthorn/core/error.h"
#include "tools/lanthorn/trade/advice_report.h"

namespace lanthorn::tools {

struct AdviceOptions {
    std::string from;  // a finished chart; empty: one is made
    Wishes wishes;
    bool markdown = false, json = false;
};
void add_advice_options(CLI::App& command, AdviceOptions& options);

// Prints what to set. Throws Error(ExitCode::check_failed) for a wish that nothing keeps within.
ExitCode advise_by(const std::vector<ChartRow>& rows, const AdviceOptions& options);
// The same by the chart of `from`, its `scenes` alone; none: all. Throws InputError for a chart that cannot
// be read, a scene that it does not have, and where nothing is wished.
ExitCode advise_from_chart(const AdviceOptions& options, const std::vector<std::string>& scenes);

}  // namespace lanthorn::tools
