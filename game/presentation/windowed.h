// The game in a window.
#pragma once

#include "game/presentation/options.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"

namespace lanthorn::game {

// From the title, or straight into a level if the options name one. Throws InputError if that level is none,
// and Error(ExitCode::no_gl) without a display or usable OpenGL. Ends after the frame under way where `stop`
// is asked, and says so.
ExitCode run_windowed(const Options& options, const StopSignal& stop);

}  // namespace lanthorn::game
