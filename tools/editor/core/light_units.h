// A light's brightness and colour in the units that people think in.
#pragma once

#include "lanthorn/core/math.h"
#include "lanthorn/scene/light.h"

namespace lanthorn::editor {

// Lumen that it sends out: of a spot those within its cone, as KHR_lights_punctual fades it from the inner to
// the outer; 0 for a directional light. Of the luminance of colour times intensity.
double lumen(const Light& light);
// The intensity with which it sends `lm` out; of directional lights unchanged.
float candela_for_lumen(const Light& light, double lm);
// Lux on a surface that faces it, 1 m away, on its axis; of directional lights anywhere.
double lux_at_one_metre(const Light& light);
// The intensity for that.
float intensity_for_lux(const Light& light, double lux);
// Metres at which a point or spot gives 1 lx on its axis; infinite for directional ones.
double reach_of_one_lux(const Light& light);

// A black body's colour, linear Rec. 709 of luminance 1, negative parts cut off. `kelvin` 1000 to 20000.
vec3 colour_of_kelvin(double kelvin);

// The black body nearest in CIE 1960 uv, and how far off the colour is: positive is green, negative pink.
struct Kelvin {
    double kelvin = 0;    // 1000 to 20000; 0: the colour is black
    double distance = 0;  // in uv; above 0.05 no temperature says much
};
Kelvin kelvin_of(const vec3& colour);

}  // namespace lanthorn::editor
