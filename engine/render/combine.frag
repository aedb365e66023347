#version 450 core
#include "combine_pixel.glsl"
