// What the manual page and the completion of `lanthorn` say beside what its options declare.
#pragma once

#include "engine/manual/bash_completion.h"
#include "engine/manual/manual_page.h"

namespace lanthorn::tools {

manual::PageText program_page();

// Presets, techniques, settings: taken from where they are declared.
manual::Values option_values();

}  // namespace lanthorn::tools
