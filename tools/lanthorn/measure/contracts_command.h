// The sub-command `contracts` of `lanthorn measure`: whether a level's light is what its light_contracts ask
// for.
#pragma once

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

Command add_measure_contracts(CLI::App& measure);

}  // namespace lanthorn::tools
