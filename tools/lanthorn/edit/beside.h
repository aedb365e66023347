// What a recorded session of a level led to here, beside what it was expected to lead to.
#pragma once

#include <string>

#include "tools/editor/window/beside_shown.h"

namespace lanthorn::tools {

// `at`: FILE:STEP. Expected is what `against`, another build of this program, comes to after that step; where
// it is empty, the state that the file has of it. Throws InputError where neither is there, and as
// recorded_state().
edit_window::BesideShown beside(const std::string& level, const std::string& at, const std::string& against);

// The rows as text, a line each.
std::string beside_text(const edit_window::BesideShown& shown);

}  // namespace lanthorn::tools
