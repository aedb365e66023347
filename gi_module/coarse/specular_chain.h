// What mirrors and glass show: a ray that is followed over them to the surfaces that send light back along
// it.
#pragma once

#include <vector>

#include "lanthorn/coarse/followed_scene.h"
#include "lanthorn/gi/emc/exact_rays.h"

namespace lanthorn::gi {

// Follows a ray over smooth metal (0.5 and more metallic, roughness below 0.3) and through transmitting
// surfaces, for at most 16 surfaces. Absorption in volumes by Beer's law. What the surface of the pixel
// itself reflects is left out; where other glass reflects as much as 0.004 of what the ray brings its
// reflection is followed too, up to four times. Appends where the ways end, that of the ray first: at least
// one.
void follow_chain(const FollowedScene& scene, const SpecularRay& ray, std::vector<SpecularHit>& ends);

}  // namespace lanthorn::gi
