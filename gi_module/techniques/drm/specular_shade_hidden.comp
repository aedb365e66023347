#version 450 core
// Mirrors and glass with the indirect light of the direct radiance maps' samples, where something hides them.
layout(local_size_x = 64) in;

#define SAMPLES_ARE_HIDDEN
#include "gi_module/shared/mirrors/specular.glsl"
#include "hidden_sample.glsl"
#include "specular_light.glsl"
#include "gi_module/shared/mirrors/specular_shade.glsl"
