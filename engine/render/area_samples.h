// Points that stand for emissive surfaces in direct light.
#pragma once

#include <vector>

#include "lanthorn/render/emissive.h"
#include "lanthorn/render/light_data.h"
#include "lanthorn/render/render_settings.h"

namespace lanthorn::render {

struct AreaSamples {
    std::vector<LightData> lights;
    std::vector<vec4> nodes;  // near_emitters.h
};

// `area_lights_max` times `area_lights_samples` points in all. A flat surface has `area_lights_samples`, one
// that shines several ways or lies in pieces more (samples_wanted()); where that is too many, each has one
// and the points that are left go where most light is. More surfaces than points: up to 64 have one each.
// More than 64: the weakest are merged, whatever they are, into 16 points of the id kMergedSurfaces, each of
// which stands for what lies together. A point lies on the surface, stands for a part of it, of its area and
// in its mean direction, and has the part's mean radiance. None is left out, but all are where
// `area_lights_max` is 0. Layers are assigned from 0, 6 each. Those that stand for parts which hang together
// have nodes of these for what is near: others do not, as their map shows what one of those parts lights. The
// same for the same triangles, and, but for those that are merged, for a surface that moves as a whole. Cost:
// 16 times triangles times points.
AreaSamples make_area_samples(const EmissiveTriangles& emissive, const RenderSettings& settings);

}  // namespace lanthorn::render
