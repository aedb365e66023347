// Points that stand for emissive surfaces in direct light.
#pragma once

#include <vector>

#include "lanthorn/render/emissive.h"
#include "lanthorn/render/light_data.h"
#include "lanthorn/render/render_settings.h"

namespace lanthorn::render {

// The strongest `area_lights_max` emissive instances by flux, `area_lights_samples` points each, spread by
// flux over the surface; each carries an equal share of the instance's flux. Layers are assigned from 0, 6
// each. The points lie on the surface and are the same for the same triangles.
std::vector<LightData> make_area_samples(const EmissiveTriangles& emissive, const RenderSettings& settings);

}  // namespace lanthorn::render
