#pragma once

#include <string>

#include "lanthorn/core/settings.h"
#include "lanthorn/scene/scene_data.h"

namespace lanthorn::tools {

// Every setting that the command line knows.
void declare_all_settings(SettingsSchema& schema);

// What the light of the scene's first frame requires with these settings, as a readable table. No GL.
std::string plan_report(const SceneData& scene, const Settings& settings);

}  // namespace lanthorn::tools
