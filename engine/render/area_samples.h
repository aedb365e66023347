// Points that stand for emissive surfaces in direct light.
#pragma once

#include <vector>

#include "lanthorn/render/emissive.h"
#include "lanthorn/render/light_data.h"
#include "lanthorn/render/render_settings.h"

namespace lanthorn::render {

// The strongest `area_lights_max` emissive instances by flux, `area_lights_samples` points each at most. A
// point lies on the surface and stands for a part of it, of its area and in its mean direction: parts that
// lie together and face the same way, so that a closed surface (a bulb) shines to all sides. Layers are
// assigned from 0, 6 each. The same for the same triangles, and for a surface that moves as a whole. Cost: 16
// times triangles times points.
std::vector<LightData> make_area_samples(const EmissiveTriangles& emissive, const RenderSettings& settings);

}  // namespace lanthorn::render
