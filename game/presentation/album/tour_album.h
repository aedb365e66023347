// The whole game played by itself, without a window.
#pragma once

#include "game/presentation/options.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"

namespace lanthorn::game {

// Plays every level of the campaign, or the one that `options` name, by its tour. Into the folder
// `options.out`, if there is one: three stills a level, LEVEL-1.png to LEVEL-3.png; then tour.webp, four
// times as fast as it was played; last index.html, which shows all. Every file is written whole or not at
// all; where `stop` is asked the stills so far stay, and there is no new page. A level that its tour does not
// solve is said on stderr: ExitCode::check_failed. Needs OpenGL, which light sensors are measured by, also
// without pictures. By default a machine without a GPU plays at preset low and draws the stills at medium.
// Cost there, two cores, 640x360: about a minute a level at medium.
ExitCode run_tour(const Options& options, const StopSignal& stop);

}  // namespace lanthorn::game
