// What a list of measured numbers comes to.
#pragma once

#include <vector>

namespace lanthorn::workbench {

// The one in the middle; of an even number the mean of the two there. 0 without any. O(n log n).
double median(std::vector<double> values);

}  // namespace lanthorn::workbench
