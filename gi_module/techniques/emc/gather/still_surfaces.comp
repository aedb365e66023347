#version 450 core
// The surface points of all pixels, about which no ray has told anything yet.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gi_module/techniques/emc/splat/splat_surface.glsl"

layout(std430, binding = 4) writeonly buffer Surfaces { vec4 surfaces[]; };
layout(std430, binding = 5) writeonly buffer Mean { vec4 mean[]; };
layout(std430, binding = 6) writeonly buffer Known { float known[]; };

void main() {
    int i = int(work_item());
    if (i >= image_size.x * image_size.y) return;
    vec3 x;
    vec3 n;
    surface_at(ivec2(i % image_size.x, i / image_size.x), x, n);
    surfaces[i] = pack_point(x, n);
    mean[i] = vec4(0.0, 0.0, 0.0, -1.0);
    known[i] = 0.0;
}
