// Which lights have a picture that the direct radiance map is sampled from (Frisvad et al. 2005, sec. 5, step
// 1), and of what shape. Point lights are seen all round, spots within their cone, emissive surfaces in the
// hemispheres that they shine into, parallel light over the scene's box.
#pragma once

#include <span>
#include <vector>

#include "gi_module/techniques/drm/radiance_sample.h"
#include "lanthorn/core/math.h"
#include "lanthorn/render/light_data.h"

namespace lanthorn::gi {

struct LightPictures {
    std::vector<render::LightData> lights;  // one a picture
    std::vector<LightPicture> shapes;       // likewise
    int left_out = 0;                       // pictures beyond `most`
    int dark = 0;                           // lights that send nothing, or nothing that is a number

    int count() const { return static_cast<int>(lights.size()); }
};

// The strongest `most` by luminous flux, those of the light maps first. `lights`: as LightMaps::light_data()
// has them, the first `punctual` with maps of their own; the samples of one emissive surface that face about
// the same way become one light, in the place of the one nearest their middle. Layers of emissive surfaces'
// pictures are assigned from 0, 6 each. `bounds`: of the scene, render space. O(lights log lights).
LightPictures choose_pictures(std::span<const render::LightData> lights, int punctual, const Aabb& bounds,
                              int most);

}  // namespace lanthorn::gi
