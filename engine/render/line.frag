#version 450 core
// How much of the pixel the line covers, by the distance of its centre.

layout(location = 0) flat in vec4 line_ends;
layout(location = 1) flat in vec4 line_colour;
layout(location = 2) flat in float line_width;

layout(location = 0) out vec4 out_colour;

void main() {
    vec2 along = line_ends.zw - line_ends.xy;
    vec2 from = gl_FragCoord.xy - line_ends.xy;
    float share = dot(along, along) > 0.0 ? clamp(dot(from, along) / dot(along, along), 0.0, 1.0) : 0.0;
    float covered = clamp(0.5 * line_width + 0.5 - length(from - share * along), 0.0, min(line_width, 1.0));
    if (covered <= 0.0) discard;
    out_colour = vec4(line_colour.rgb, line_colour.a * covered);
}
