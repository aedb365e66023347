// KHR_materials_pbrSpecularGlossiness: textures of glossiness as textures of roughness.
#pragma once

#include "lanthorn/scene/material.h"

namespace lanthorn {

// Glossiness is the alpha times `factor` (0..1); the image becomes what glTF reads roughness from: 1 less
// that in G, 0 in R and B.
void roughness_of_glossiness(Image& image, double factor);

}  // namespace lanthorn
