#version 450 core
#define COMPUTE
#include "direct_pixel.glsl"
