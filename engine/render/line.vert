#version 450 core
// A rectangle around each line: two triangles, with a pixel to spare.
#include "strip_data.h"

layout(std430, binding = 0) readonly buffer PictureLines {
    PictureLine lines[];
};

uniform vec2 picture_size;  // pixels
uniform int first_line;

layout(location = 0) flat out vec4 line_ends;
layout(location = 1) flat out vec4 line_colour;
layout(location = 2) flat out float line_width;

void main() {
    PictureLine line = lines[first_line + gl_InstanceID];
    vec2 along = line.to - line.from;
    float size = length(along);
    along = size > 0.0 ? along / size : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);
    float reach = 0.5 * line.width + 1.0;
    // Corners of the triangle strip: from/to by bit 0, left/right by bit 1.
    bool at_end = (gl_VertexID & 1) != 0;
    vec2 corner = at_end ? line.to + along * reach : line.from - along * reach;
    corner += across * ((gl_VertexID & 2) != 0 ? reach : -reach);
    gl_Position = vec4(corner / picture_size * 2.0 - 1.0, at_end ? line.to_depth : line.from_depth, 1.0);
    line_ends = vec4(line.from, line.to);
    line_colour = line.colour;
    line_width = line.width;
}
