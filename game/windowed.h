// The game in a window.
#pragma once

#include "game/options.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {

// From the title, or straight into a level if the options name one. Throws InputError if that level is none,
// and Error(ExitCode::no_gl) without a display or usable OpenGL.
ExitCode run_windowed(const Options& options);

}  // namespace lanthorn::game
