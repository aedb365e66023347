// The game in a window.
#pragma once

#include "engine/core/error.h"
#include "engine/scene/scene_data.h"
#include "game/level.h"
#include "game/options.h"

namespace lanthorn::game {

ExitCode run_windowed(const Options& options, const SceneData& scene, const Level& level);

}  // namespace lanthorn::game
