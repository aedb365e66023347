// The game in a window.
#pragma once

#include "game/level.h"
#include "game/options.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::game {

ExitCode run_windowed(const Options& options, const SceneData& scene, const Level& level);

}  // namespace lanthorn::game
