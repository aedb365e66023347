// Which of a file's cameras is meant.
#pragma once

#include <cstdint>
#include <string>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

bool has_camera(const SceneData& scene);

// The node whose camera is meant, by SceneChoice::camera; kNone for one that sees everything. Throws
// InputError for one that is not there.
std::uint32_t find_camera(const SceneData& scene, const std::string& wanted);

}  // namespace lanthorn
