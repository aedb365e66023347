// The subcommands of `lanthorn`. Each adds itself to the command line and returns what to call if it was
// chosen. A command returns its exit code, and throws lanthorn::Error for what a user can mend.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "lanthorn/core/error.h"

namespace lanthorn::tools {

using Command = std::function<ExitCode()>;

Command add_bench(CLI::App& app);
Command add_render(CLI::App& app);
Command add_compare(CLI::App& app);
Command add_inspect(CLI::App& app);
Command add_convert(CLI::App& app);
Command add_edit(CLI::App& app);
Command add_measure(CLI::App& app);
Command add_trade(CLI::App& app);
Command add_replay(CLI::App& app);
Command add_trade_point(CLI::App& app);  // hidden: what trade runs for each of its points
Command add_farm_slice(CLI::App& app);   // hidden: what a task of a farm runs

}  // namespace lanthorn::tools
