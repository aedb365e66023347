// Scenes whose light is known on paper, traced.
#pragma once

#include "lanthorn/reference/path_tracer.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::reference::test {

using support::directional_light;
using support::lambertian;
using support::lamp;
using support::look_closely;
using support::point_light;
using support::quad;
using support::scene_of;
using support::sphere;
using support::spot_light;

// Mean over all pixels and channels of one AOV after settings.spp samples, in double precision.
double mean_of(const FrameScene& scene, const PathSettings& settings, PathAov aov, ivec2 size = ivec2(16));

}  // namespace lanthorn::reference::test
