// What mirrors and glass show: a ray that is followed over them to the surface that sends light back along
// it.
#pragma once

#include "lanthorn/coarse/followed_scene.h"
#include "lanthorn/gi/emc/exact_rays.h"

namespace lanthorn::gi {

// Fresnel's reflectance of unpolarised light at a smooth boundary. `cosine` of the angle of incidence, 0..1;
// `eta`: index of refraction of where the light comes from over that of where it goes. 1 beyond the critical
// angle.
float fresnel_reflectance(float cosine, float eta);

// Follows a ray over smooth metal (0.5 and more metallic, roughness below 0.3) and through transmitting
// surfaces, whose reflections it leaves out unless they are total, for at most eight surfaces. Absorption in
// volumes by Beer's law.
SpecularHit follow_chain(const FollowedScene& scene, const SpecularRay& ray);

}  // namespace lanthorn::gi
