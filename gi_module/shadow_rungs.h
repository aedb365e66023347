// What lamps' maps are spared of, whatever technique carries the light on: their texels.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/runtime/budget_control.h"

namespace lanthorn::gi {

// The next side below `texels` of the maps of lamps, at least 128 and no texel wider than about three of a
// picture's `rows`: edges of shadows get no larger stairs. `texels` itself where there is none.
int fewer_shadow_texels(int texels, int rows);

// KEY=VALUE that make the maps of lamps `texels` a side, and those of emissive surfaces smaller by as much.
std::vector<std::string> shadow_assignments(const Settings& settings, int texels);

// Adds the rungs that spare them, of `group`, after the last one.
void add_coarser_shadows(BudgetLadder& ladder, const Settings& settings, int rows, std::size_t group);

}  // namespace lanthorn::gi
