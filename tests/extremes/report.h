// The table of all rows, printed when the last has run. Its columns:
//
// clang-format off
//   relRMSE   of the indirect irradiance, less the truth's own noise; in ordinary errors; and their bound
//   flux      mean over the truth's mean, and the bound of its distance from 1
//   unlike    relRMSE against the ordinary image itself, where there is one
//   energy    stored flux over what the albedos allow, the largest of all bounces
//   lost      share of photons that no map had a hit for, a bounce
//   leak      light where there is none in truth, over the picture's mean
//   k         maps in use
//   NaN       values that are not finite, and pixels where the composite met one
// clang-format on
#pragma once

#include "tests/extremes/judge.h"

namespace lanthorn::extremes {

void report(const Row& row, const Outcome& outcome);
void print_table();

}  // namespace lanthorn::extremes
