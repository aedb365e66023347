// lamplighter --prepare: has the OpenGL driver compile, and keep in its cache, what pictures of the levels
// need, so that no start has to wait for it.
#pragma once

#include "game/presentation/options.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"

namespace lanthorn::game {

// Of every level of the campaign, or the one that is named; a line on stdout for each. Throws InputError for
// a level that cannot be read, Error without OpenGL.
ExitCode run_prepare(const Options& options, const StopSignal& stop);

}  // namespace lanthorn::game
