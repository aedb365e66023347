// What is spared of a frame to hold a time: a technique's own sizes first, then pixels; and which passes each
// of them is paid in.
#pragma once

#include <span>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gpu/pass_timer.h"
#include "lanthorn/runtime/budget_control.h"

namespace lanthorn::gi {

// Passes whose time follows the same sizes.
enum class CostGroup {
    gather,    // rays of the picture's points: their number times their rays
    filter,    // of the points alone
    lit_maps,  // texels
    photons,   // that light these
    pixels,    // all that is drawn or computed by pixel
    shadows,   // texels of lamps' maps
    rest,      // environment maps, what moves: nothing here spares it
};
inline constexpr std::size_t kCostGroups = 7;

// Of the technique that the settings name. `pixels`: whether the picture may become smaller in the end.
BudgetLadder quality_ladder(const Settings& settings, ivec2 size, bool pixels);

// A frame's time by group: what each pass takes, `frame_ms` less all of them as the rest. `processor`: of
// processor time.
std::vector<double> group_costs(std::span<const gpu::PassTimer::Span> passes, double frame_ms,
                                bool processor);

}  // namespace lanthorn::gi
