// Trees of many lamps: what is far away is added up as a group, after Walter et al. 2005 (Lightcuts), and
// what no lamp of a group reaches is passed over. Read by lamp_tree.glsl.
#pragma once

#include "lanthorn/render/shining_lights.h"

namespace lanthorn::render {

// The largest radius of a group over its distance for which the group's illuminance, taken from its mean
// place and its second moments, is within a share `error` of the sum over its lamps.
float lamp_closeness(float error);

// Makes the trees of `shining`'s point lamps, spots and other lamps. Lamps that are not finite are in none.
// Their nodes lie in the order of a walk that goes to a node's children first, with a link past them. Point
// lamps make groups; of others every one is taken that reaches. O(n log n); 2 n nodes of 96 bytes.
void build_lamp_trees(ShiningLights& shining, float error);

}  // namespace lanthorn::render
