// The lights that shading adds up, by kind (shining_lights.h): WITH_DIRECTIONAL, WITH_POINT, WITH_SPOT, WITH_OTHER, WITH_AREA tell of
// which there is at least one. Loops over them test at their end and have no `continue`: a software rasteriser runs a loop's body once
// more for a test at its start, and both sides of every `if`. LAMP_TREES: they are many, and groups of point lamps stand for their
// lamps (lamp_tree.glsl).
#ifndef LANTHORN_SHINING_LIGHTS_GLSL
#define LANTHORN_SHINING_LIGHTS_GLSL
#include "lights.glsl"
#ifdef LAMP_TREES
#include "lamp_tree.glsl"

// Behind the last node of each kind's tree; the next one's begin there.
uniform int point_nodes_end;
uniform int spot_nodes_end;
uniform int other_nodes_end;
#endif

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

// Statement ADD(light) for each punctual light that reaches AT, its kind known where it is compiled; PUNCTUAL_LIGHTS(ADD, AT) in a
// function's body. AT: a LampTarget, where there are trees.
#define LIGHTS_OF_KIND(ADD, LIGHT, BEGIN, END) { int i = BEGIN; do { ADD(LIGHT) } while (++i < END); }
#define LIGHTS_OF_NODES(ADD, LIGHT, NEXT, BEGIN, END, AT) { int i = BEGIN; do { int node = NEXT(AT, i, END, i); ADD(LIGHT) } while (i < END); }
#ifdef WITH_DIRECTIONAL
#define DIRECTIONAL_LIGHTS(ADD) LIGHTS_OF_KIND(ADD, light_of_kind(i, kLightDirectional, 1u), 0, directional_end)
#else
#define DIRECTIONAL_LIGHTS(ADD)
#endif
#ifndef WITH_POINT
#define POINT_LIGHTS(ADD, AT)
#elif defined LAMP_TREES
#define POINT_LIGHTS(ADD, AT) LIGHTS_OF_NODES(ADD, lamps_of(node, AT, node < point_nodes_end), next_lamps, 0, point_nodes_end, AT)
#else
#define POINT_LIGHTS(ADD, AT) LIGHTS_OF_KIND(ADD, light_of_kind(i, kLightPoint, 6u), directional_end, point_end)
#endif
#ifndef WITH_SPOT
#define SPOT_LIGHTS(ADD, AT)
#elif defined LAMP_TREES
#define SPOT_LIGHTS(ADD, AT) LIGHTS_OF_NODES(ADD, narrow_spot_of(node, node < spot_nodes_end), next_spot, point_nodes_end, spot_nodes_end, AT)
#else
#define SPOT_LIGHTS(ADD, AT) LIGHTS_OF_KIND(ADD, light_of_kind(i, kLightSpot, 1u), point_end, spot_end)
#endif
#ifndef WITH_OTHER
#define OTHER_LIGHTS(ADD, AT)
#elif defined LAMP_TREES
#define OTHER_LIGHTS(ADD, AT) LIGHTS_OF_NODES(ADD, spot_of(node, node < other_nodes_end), next_spot, spot_nodes_end, other_nodes_end, AT)
#else
#define OTHER_LIGHTS(ADD, AT) LIGHTS_OF_KIND(ADD, lights[i], spot_end, punctual_end)
#endif
#define PUNCTUAL_LIGHTS(ADD, AT) DIRECTIONAL_LIGHTS(ADD) POINT_LIGHTS(ADD, AT) SPOT_LIGHTS(ADD, AT) OTHER_LIGHTS(ADD, AT)

#ifdef WITH_AREA
#define AREA_LIGHTS(ADD) LIGHTS_OF_KIND(ADD, light_of_kind(i, kLightAreaSample, 6u), punctual_end, light_end)
#else
#define AREA_LIGHTS(ADD)
#endif

#endif
