#include "tools/lanthorn/measure/scene_list.h"

#include <algorithm>

#include "lanthorn/workbench/all_settings.h"
#include "tools/lanthorn/common/warnings.h"

namespace lanthorn::tools {

void add_scenes_option(CLI::App& command, std::vector<std::string>& scenes) {
    command.add_option("SCENE", scenes, "glTF 2.0 files (.gltf, .glb), FILE@CAMERA for one of its cameras")
        ->required();
}

MotionScene open_scene(const std::string& text, const SceneView& view) {
    ListedScene listed = listed_scene(text, view);
    SceneData data = tell_warnings(listed.file, load_scene(listed.file, listed.view));
    return {std::move(listed.name), std::move(data), std::move(listed.view)};
}

std::vector<Motion> motions_named(const std::vector<std::string>& names) {
    std::vector<Motion> motions;
    std::ranges::transform(names, std::back_inserter(motions), motion_named);
    return motions;
}

MotionCase case_of(std::string name, const SettingsChoice& choice, const SettingsSchema& schema) {
    MotionCase one{std::move(name), measured_settings(schema)};
    choice.apply_to(one.settings);
    return one;
}

}  // namespace lanthorn::tools
