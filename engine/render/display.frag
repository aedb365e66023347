#version 450 core
#include "display_pixel.glsl"
