// What the rows look at, at ordinary numbers.
#pragma once

#include "tests/extremes/stage.h"

namespace lanthorn::extremes {

// A closed room of 4 x 2.6 x 3 m with a red block and a green shelf on its floor, lit by a bulb of 100 cd.
Stage room();

// Inside of a sphere of 1 m with 100 cd at its centre: after b reflections, albedo^b * 100 lux arrive
// everywhere (Jacquez and Kuppenheim 1955).
Stage sphere(float albedo);
double sphere_irradiance(float albedo, int bounces);  // lux, the sum over 1..bounces

}  // namespace lanthorn::extremes
