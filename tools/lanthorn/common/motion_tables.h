// What moves in a scene, for `lanthorn inspect`.
#pragma once

#include <string>

#include "lanthorn/scene/scene_data.h"
#include "tools/lanthorn/common/text_table.h"

namespace lanthorn::tools {

TextTable animation_table(const SceneData& scene);
TextTable skin_table(const SceneData& scene);
// "skin of up to 4 joints, 2 morph targets, catmull-clark to level 2"; "-" for a mesh that does not deform.
std::string deformation_text(const Mesh& mesh);

}  // namespace lanthorn::tools
