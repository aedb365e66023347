// The sub-command `estimate` of `lanthorn measure`.
#pragma once

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

Command add_measure_estimate(CLI::App& measure);

}  // namespace lanthorn::tools
