#version 450 core
// Mirrors and glass with the indirect light of the direct radiance maps.
layout(local_size_x = 64) in;

#include "gi_module/shared/mirrors/specular.glsl"
#include "specular_light.glsl"
#include "gi_module/shared/mirrors/specular_shade.glsl"
