// What the samples of direct radiance maps see: beyond Frisvad et al. 2005, in which every sample is seen
// from everywhere (sec. 3: no indirect shadows) and light is reflected once. A sample that has a picture
// lights what it sees alone (a shadow map by sample, as Ritschel et al. 2008 have them of points), and the
// picture is a direct radiance map again, of which samples of the next reflection are taken.
#pragma once

#include <vector>

#include "gi_module/techniques/drm/drm_settings.h"
#include "gi_module/techniques/drm/light_pictures.h"
#include "gi_module/techniques/drm/radiance_sample.h"

namespace lanthorn::gi {

// At most: of the smallest allowed array texture's 2048 layers six each.
inline constexpr int kMostSamplePictures = 256;

// The lights that samples are to others, the strongest kMostSamplePictures by what they send on; each is
// named by its sample (RadianceSample::picture: the first of its layers, -1 without). `diagonal`: of the
// scene's box, metres. `cells`: M x M. O(samples log samples).
LightPictures pictures_of_samples(std::vector<RadianceSample>& samples, SolidAngle kind, float diagonal,
                                  int cells);

}  // namespace lanthorn::gi
