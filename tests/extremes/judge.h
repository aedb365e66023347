// Renders a row and says what came of it.
#pragma once

#include <cstdint>
#include <vector>

#include "lanthorn/gi/statistics.h"
#include "tests/extremes/row.h"
#include "tests/extremes/truth.h"

namespace lanthorn::extremes {

struct Outcome {
    std::vector<float> lux;        // the indirect irradiance
    std::uint64_t not_finite = 0;  // values of indirect, direct, radiance and final together
    std::uint64_t negative = 0;    // values of indirect
    std::uint64_t replaced = 0;    // pixels where the composite met NaN or infinity
    gi::GiStatistics statistics;
    double emission_off = 0;  // relative error of the flux said to be emitted against the lamps' closed forms
    double gained = 0;  // largest stored flux over emitted * largest albedo^bounce, over bounces; at most 1
    double lost = 0;    // share of photons lost, a bounce
    Difference off;     // from the truth
    double ordinary_error = 0;  // relRMSE of the row's ordinary scene
    double unlike =
        0;  // relRMSE against the ordinary image, the worse of indirect and direct; Right::ordinary alone
};

Outcome outcome_of(const Row& row);

// What is not as the row has it, a line each: bounds that do not hold, and known defects that are worse than
// known or mended.
std::vector<std::string> complaints(const Row& row, const Outcome& outcome);

// How far the ordinary scene of that size is off: the measure of the rows' errors, which needs a bound of its
// own.
Difference ordinary_difference(Ordinary which, ivec2 size);

}  // namespace lanthorn::extremes
