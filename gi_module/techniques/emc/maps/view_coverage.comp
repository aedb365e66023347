#version 450 core
// How many maps see what each pixel shows: its surface faces the map's centre and lies where the map's texel has its plane, to two
// texels.
layout(local_size_x = 8, local_size_y = 8) in;

#include "intersection.glsl"
#include "engine/render/camera.glsl"

layout(rgba32f, binding = 0) writeonly uniform image2D seen;
uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform ivec2 image_size;
uniform vec4 slots[MAX_MAPS];  // x: of each map
uniform int slot_count;

bool sees(int slot, vec3 x, vec3 n) {
    vec3 o = x - map_centres[slot].xyz;
    vec3 g = plane_at(map_texel(slot, o));
    float along = dot(o, g);  // |o| over the distance of the texel's plane
    float tolerance = 4.0 / float(map_resolution);
    return g != vec3(0.0) && dot(o, n) < 0.0 && abs(along - 1.0) < tolerance;
}

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, image_size))) return;
    float d = texelFetch(gbuffer_distance, p, 0).r;
    vec3 x = render_position((vec2(p) + 0.5) / vec2(image_size), d);
    vec3 n = octahedral_decode(texelFetch(gbuffer_normals, p, 0).zw);
    float count = 0.0;
    for (int i = 0; i < slot_count && d > 0.0; ++i) {
        count += sees(int(slots[i].x), x, n) ? 1.0 : 0.0;
    }
    imageStore(seen, p, vec4(vec3(count), 1.0));
}
