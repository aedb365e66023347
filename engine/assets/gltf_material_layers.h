// Layers upon a material that the engine does not shade by themselves: what they do to the light that it
// sends back is put into the material below.
#pragma once

#include "lanthorn/scene/material.h"

namespace lanthorn {

// KHR_materials_clearcoat of strength `factor` (0..1): a coat of ior 1.5 (F0 0.04) that reflects and lets
// only the rest through, twice. What it reflects becomes part of the surface's own reflection (wider than the
// coat's, if the surface is rough), and dims its diffuse colour. A metal reflects about as much with it as
// without.
void add_clearcoat(Material& material, float factor);

// KHR_materials_sheen: fibres that reflect `colour` (linear, 0..1), mostly at grazing angles, `roughness`
// 0..1. By the layer's mean albedo E (Conty Estevez and Kulla 2017; the fit of three.js's
// IBLSheenBRDF) the diffuse colour gains E * colour and keeps 1 - E * the largest of it: as much light as
// with the layer, spread evenly over the angles.
void add_sheen(Material& material, const vec3& colour, float roughness);

// E of a white sheen, the mean over the hemisphere of directions; 0..1. O(1).
float sheen_albedo(float roughness);

}  // namespace lanthorn
