// A replay's time as a picture: lanes for input, parts that changed, and the states that were equal or not.
#pragma once

#include <string>

#include "tools/replay_suite/result.h"

namespace lanthorn::suite {

// SVG, for the middle of an HTML page; empty for a result without steps. Lanes of which `verify` wrote
// nothing are left out.
std::string timeline_svg(const Result& result);

}  // namespace lanthorn::suite
