#version 450 core
// Each cell's plane, as the filter asks for it.
layout(local_size_x = 8, local_size_y = 8) in;

uniform samplerBuffer points;  // SurfacePoint
uniform ivec2 cells;
uniform vec3 camera_position;
layout(rgba32f, binding = 0) uniform writeonly image2D planes;  // normal, distance from the camera's position; 0: nothing

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(cell, cells))) return;
    int i = 2 * (cell.y * cells.x + cell.x);
    vec4 where = texelFetch(points, i);
    vec3 normal = texelFetch(points, i + 1).xyz;
    vec4 plane = vec4(normal, dot(normal, where.xyz - camera_position));
    imageStore(planes, cell, where.w > 0.0 ? plane : vec4(0.0));
}
