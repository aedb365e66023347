// Least squares whose unknowns may not be below 0.
#pragma once

#include <span>
#include <vector>

namespace lanthorn::editor {

// One equation of a system: what each unknown counts in it, and what they are to add up to.
struct Equation {
    std::vector<double> factors;  // as many as there are unknowns
    double sum = 0;
};

// The unknowns, none below 0, with the least sum of squares of what the equations are missed by (Lawson and
// Hanson 1974, algorithm 23.10). Unknowns that no equation tells apart share nothing out by themselves: give
// each a faint equation of its own. O(unknowns^3) a step; some steps an unknown.
std::vector<double> non_negative_solution(std::span<const Equation> equations);

}  // namespace lanthorn::editor
