// The scenes, motions and cases that a measure's command line lists.
#pragma once

#include <string>
#include <vector>

#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/measure_motions.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

// SCENE...
void add_scenes_option(CLI::App& command, std::vector<std::string>& scenes);

// A scene as listed_scene() takes it; its warnings are printed. Throws InputError as load_scene().
MotionScene open_scene(const std::string& text, const SceneView& view);

// As motion_named(), one after the other.
std::vector<Motion> motions_named(const std::vector<std::string>& names);

// Settings to be compared with references (measured_settings()), as `choice` asks. `schema` must outlive it.
MotionCase case_of(std::string name, const SettingsChoice& choice, const SettingsSchema& schema);

}  // namespace lanthorn::tools
