// The game without a window: the tour or a replay, with pictures if asked for.
#pragma once

#include "engine/core/error.h"
#include "engine/scene/scene_data.h"
#include "game/level.h"
#include "game/options.h"

namespace lanthorn::game {

ExitCode run_headless(const Options& options, const SceneData& scene, const Level& level);

}  // namespace lanthorn::game
