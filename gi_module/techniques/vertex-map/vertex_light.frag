#version 450 core
// The light of a triangle's corners, interpolated.
#include "shown.glsl"

in vec3 relative;
in vec3 light;

layout(location = 0) out vec4 irradiance;  // lux; a = 1: there is some

void main() {
    if (!is_shown(relative)) discard;
    irradiance = vec4(light, 1.0);
}
