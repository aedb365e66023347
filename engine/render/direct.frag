#version 450 core
#include "direct_pixel.glsl"
