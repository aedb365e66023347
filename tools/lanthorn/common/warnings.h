#pragma once

#include <string>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn::tools {

// Prints the scene's warnings to standard error, a line each, and passes the scene on.
SceneData tell_warnings(const std::string& file, SceneData scene);

}  // namespace lanthorn::tools
