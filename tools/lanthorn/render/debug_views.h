// Debug views of techniques (gi/technique.h) on the command line.
#pragma once

#include <string>

namespace lanthorn::tools {

// Those of every technique, a line each.
std::string list_debug_views();

}  // namespace lanthorn::tools
