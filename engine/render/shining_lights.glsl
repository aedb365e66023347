// The lights that shading adds up, by kind (shining_lights.h): WITH_DIRECTIONAL, WITH_POINT, WITH_SPOT, WITH_OTHER, WITH_AREA tell of
// which there is at least one. Loops over them test at their end and have no `continue`: a software rasteriser runs a loop's body once
// more for a test at its start, and both sides of every `if`.
#ifndef LANTHORN_SHINING_LIGHTS_GLSL
#define LANTHORN_SHINING_LIGHTS_GLSL
#include "lights.glsl"

// Behind the last light of each kind; the next one's begin there.
uniform int directional_end;
uniform int point_end;
uniform int spot_end;
uniform int punctual_end;
uniform int light_end;

// Light `i`, of a known type and number of layers.
LightData light_of_kind(int i, uint type, uint layers) {
    LightData light = lights[i];
    light.type = type;
    light.layers = layers;
    return light;
}

// Statement ADD(light) for each punctual light, its kind known where it is compiled; PUNCTUAL_LIGHTS(ADD) in a function's body.
#define LIGHTS_OF_KIND(ADD, LIGHT, BEGIN, END) { int i = BEGIN; do { ADD(LIGHT) } while (++i < END); }
#ifdef WITH_DIRECTIONAL
#define DIRECTIONAL_LIGHTS(ADD) LIGHTS_OF_KIND(ADD, light_of_kind(i, kLightDirectional, 1u), 0, directional_end)
#else
#define DIRECTIONAL_LIGHTS(ADD)
#endif
#ifdef WITH_POINT
#define POINT_LIGHTS(ADD) LIGHTS_OF_KIND(ADD, light_of_kind(i, kLightPoint, 6u), directional_end, point_end)
#else
#define POINT_LIGHTS(ADD)
#endif
#ifdef WITH_SPOT
#define SPOT_LIGHTS(ADD) LIGHTS_OF_KIND(ADD, light_of_kind(i, kLightSpot, 1u), point_end, spot_end)
#else
#define SPOT_LIGHTS(ADD)
#endif
#ifdef WITH_OTHER
#define OTHER_LIGHTS(ADD) LIGHTS_OF_KIND(ADD, lights[i], spot_end, punctual_end)
#else
#define OTHER_LIGHTS(ADD)
#endif
#define PUNCTUAL_LIGHTS(ADD) DIRECTIONAL_LIGHTS(ADD) POINT_LIGHTS(ADD) SPOT_LIGHTS(ADD) OTHER_LIGHTS(ADD)

#ifdef WITH_AREA
#define AREA_LIGHTS(ADD) LIGHTS_OF_KIND(ADD, light_of_kind(i, kLightAreaSample, 6u), punctual_end, light_end)
#else
#define AREA_LIGHTS(ADD)
#endif

#endif
