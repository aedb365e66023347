// The table of all rows, printed when the last has run.
#pragma once

#include "tests/extremes/judge.h"

namespace lanthorn::extremes {

void report(const Row& row, const Outcome& outcome);
void print_table();

}  // namespace lanthorn::extremes
