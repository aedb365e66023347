// What the gather spares first.
#pragma once

#include "lanthorn/gi/quality_ladder.h"

namespace lanthorn::gi {

// From the settings' rays, grid, texels, photons and texels of lamps' maps down to the least of each, in the
// order of what the error grows by for the time that it saves (docs/budgets.md); no rung but the first where
// photons are splatted.
BudgetLadder emc_ladder(const Settings& settings, ivec2 size);

}  // namespace lanthorn::gi
