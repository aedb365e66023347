// What mirrors and glass show: a ray that is followed over them to the surface that sends light back along
// it.
#pragma once

#include "lanthorn/coarse/followed_scene.h"
#include "lanthorn/gi/emc/exact_rays.h"

namespace lanthorn::gi {

// Follows a ray over smooth metal (0.5 and more metallic, roughness below 0.3) and through transmitting
// surfaces, whose reflections it leaves out unless they are total, for at most 16 surfaces. Absorption in
// volumes by Beer's law.
SpecularHit follow_chain(const FollowedScene& scene, const SpecularRay& ray);

}  // namespace lanthorn::gi
