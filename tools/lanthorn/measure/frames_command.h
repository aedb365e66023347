// The sub-command `frames` of `lanthorn measure`: what frames cost on this machine, by pass.
#pragma once

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

Command add_measure_frames(CLI::App& measure);

}  // namespace lanthorn::tools
