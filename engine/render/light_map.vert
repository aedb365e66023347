#version 450 core
// A triangle onto one layer of a light's map.
#define KEEPS_ALBEDO
#include "scene_vertex.glsl"
#include "light_map.glsl"

uniform int light_index;
uniform int face;
uniform float near;

void main() { gl_Position = light_map_clip(lights[light_index], face, fetch_vertex(), near); }
