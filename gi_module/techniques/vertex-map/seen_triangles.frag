#version 450 core
// Marks the triangles that the picture shows.
#include "shown.glsl"

layout(std430, binding = 0) writeonly buffer Seen {
    uint seen[];
};

in vec3 relative;

void main() {
    if (is_shown(relative)) seen[gl_PrimitiveID] = 1u;
}
