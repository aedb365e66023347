// Exporters mark materials as see-through that are not: what they show is then sorted, casts no shadow and
// takes no part in indirect light, for nothing.
#pragma once

#include <vector>

#include "lanthorn/scene/scene_data.h"

namespace lanthorn {

// Makes opaque what is AlphaMode::blend though its factor, its texture and the vertices that it colours have
// an alpha of 1 everywhere, and no clip changes that. Each says so in the warnings. A material that is to
// have a texture, by its index in `textured`, and has lost it is left alone. O(texels + vertices).
void make_solid_blends_opaque(SceneData& scene, const std::vector<bool>& textured);

}  // namespace lanthorn
