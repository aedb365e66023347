// The sub-command `photons` of `lanthorn measure`: gi.vertex-map.total and per_frame for a frame's time.
#pragma once

#include "tools/lanthorn/commands.h"

namespace lanthorn::tools {

Command add_measure_photons(CLI::App& measure);

}  // namespace lanthorn::tools
