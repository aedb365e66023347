// The sub-command `why` of `lanthorn measure`: the light of one pixel, split by where it comes from.
#pragma once

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

Command add_measure_why(CLI::App& measure);

}  // namespace lanthorn::tools
