// What moves in a scene, for `lanthorn inspect`.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lanthorn/scene/scene_data.h"
#include "tools/lanthorn/common/text_table.h"

namespace lanthorn::tools {

// What a clip moves.
struct ClipContents {
    std::size_t nodes = 0;           // how many
    std::vector<std::string> paths;  // of "translation", "rotation", "scale", "weights"
};
ClipContents clip_contents(const AnimationClip& clip);

// Joints that move one vertex, at most; 0 without a skin.
std::size_t most_influences(const Mesh& mesh);
// "catmull-clark" or "loop".
const char* subdivision_name(SubdivisionScheme scheme);

TextTable animation_table(const SceneData& scene);
TextTable skin_table(const SceneData& scene);
// "skin of up to 4 joints, 2 morph targets, catmull-clark to level 2"; "-" for a mesh that does not deform.
std::string deformation_text(const Mesh& mesh);

}  // namespace lanthorn::tools
