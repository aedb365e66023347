// `lanthorn render --turntable`: a scene from all sides, as an animated picture.
#pragma once

#include <string>

#include "lanthorn/core/settings.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/workbench/render/turntable.h"

namespace lanthorn::tools {

inline constexpr int kTurntablePictures = 48, kFewestTurntablePictures = 2, kMostTurntablePictures = 1000;

// Throws InputError unless a picture of that size can be written to `file` now, which must end in .webp.
void check_turntable(const std::string& file, const TurntableJob& job);

// Writes `file`, whole or not at all. Throws what render_turntable() does, InputError where it cannot be
// written, and Stopped where a signal came first.
void write_turntable(const std::string& file, SceneData scene, const Settings& settings,
                     const TurntableJob& job);

}  // namespace lanthorn::tools
