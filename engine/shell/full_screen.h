// A window as large as the screen, and back.
#pragma once

#include "lanthorn/core/math.h"

struct GLFWwindow;

namespace lanthorn::shell {

// `whole`: the first monitor's, in its own mode. Else a window of `size`, or as much of it as the monitor has
// room for, in the middle. Without a monitor nothing changes.
void fill_screen(GLFWwindow* window, bool whole, ivec2 size);

}  // namespace lanthorn::shell
