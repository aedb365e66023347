// Pictures of marks on the suite's page: expected, actual, difference, in the page itself.
#pragma once

#include <string>

#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

// Of a result's pictures those that differ, whole; the others as a line each. Empty where none was looked at.
// A file that is gone is said to be.
std::string pictures_html(const Result& result);

}  // namespace lanthorn::suite
