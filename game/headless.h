// The game without a window: the tour or a replay, with pictures if asked for.
#pragma once

#include "game/options.h"
#include "lanthorn/core/error.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::game {

ExitCode run_headless(const Options& options, const SceneData& scene);

}  // namespace lanthorn::game
