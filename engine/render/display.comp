#version 450 core
#define COMPUTE
#include "display_pixel.glsl"
