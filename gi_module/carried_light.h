// How much of the light that a scene emits each of its reflections carries: an estimate from boxes, areas and
// albedos, without a ray.
#pragma once

#include "lanthorn/gi/plan.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// Radiosity (Goral et al. 1984, eq. 5) of pieces that are instances' bounding boxes: a piece of area A at a
// distance d takes light in proportion to A / d^2, and nothing hides anything. A lamp's light falls on what
// its cone and range reach; an emissive surface is a lamp at its centre. A piece lights itself where it may
// be hollow: large, or a lamp or another piece in its box. Where there are too many instances to tell, where
// boxes have no area or no lamp reaches any: powers of the brightest albedo, a bound.
//
// Textures count as their factors allow, so that what is estimated is rather too much.
// O(instances x 16 + 64^2), no memory but its own.
CarriedLight carried_light(const FrameScene& scene, float brightest);

// The albedo of a surface under even light, a bound over what its textures can reach: largest channel, 0..1.
float albedo_of(const Material& material);

}  // namespace lanthorn::gi
