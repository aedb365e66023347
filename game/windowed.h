// The game in a window.
#pragma once

#include "game/options.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::game {

ExitCode run_windowed(const Options& options, const SceneData& scene);

}  // namespace lanthorn::game
