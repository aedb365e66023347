#version 450 core
#define COMPUTE
#include "combine_pixel.glsl"
