#version 450 core
// Mirrors and glass with indirect light that is known hit by hit.
layout(local_size_x = 64) in;

#include "specular.glsl"

layout(std430, binding = 4) readonly buffer Irradiances { vec4 irradiances[]; };  // lux

vec3 indirect_irradiance(uint end, SpecularHit hit) { return irradiances[end].rgb; }

#define LAMPS_MAY_BE_KNOWN
#include "specular_shade.glsl"
