// The sub-command `costs` of `lanthorn measure`: where each millisecond and megabyte goes.
#pragma once

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

Command add_measure_costs(CLI::App& measure);

}  // namespace lanthorn::tools
