// The sub-command `plan` of `lanthorn measure`.
#pragma once

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

Command add_measure_plan(CLI::App& measure);

}  // namespace lanthorn::tools
