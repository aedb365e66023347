// The game without a window: the tour or a replay, with pictures if asked for.
#pragma once

#include "game/presentation/options.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::game {

// Ends early where `stop` is asked, and says so.
ExitCode run_headless(const Options& options, const SceneData& scene, const StopSignal& stop);

}  // namespace lanthorn::game
