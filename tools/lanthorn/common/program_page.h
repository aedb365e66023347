// What the manual page and the completion of `lanthorn` say beside what its options declare.
#pragma once

#include "tools/manual/bash_completion.h"
#include "tools/manual/manual_page.h"

namespace lanthorn::tools {

manual::PageText program_page();

// Presets, techniques, settings: taken from where they are declared.
manual::Values option_values();

}  // namespace lanthorn::tools
