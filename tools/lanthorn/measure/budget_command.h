// The sub-command `budget` of `lanthorn measure`.
#pragma once

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

Command add_measure_budget(CLI::App& measure);

}  // namespace lanthorn::tools
