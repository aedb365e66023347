// Appends to the list of surface points at bindings 0, 1 and 3.
#ifndef LANTHORN_EMC_POINT_APPEND_GLSL
#define LANTHORN_EMC_POINT_APPEND_GLSL

#include "point_lists.glsl"

layout(std430, binding = 0) buffer PointHeader { uint point_count; uint point_groups[3]; uint ray_groups[3]; };
layout(std430, binding = 1) writeonly buffer Points { vec4 points[]; };
layout(std430, binding = 3) writeonly buffer Keys { uint keys[]; };

uniform int rays;  // a point and frame

uint append_point(vec3 x, vec3 n, uint key) {
    uint place;
    TAKE_PLACES(point_count, 1u, place)
    points[place] = pack_point(x, n);
    keys[place] = key;
    COUNT_GROUPS(point_groups, place, place, 256u)
    uint first_ray = place * uint(rays);
    COUNT_GROUPS(ray_groups, first_ray, first_ray + uint(rays) - 1u, 256u)
    return place;
}

#endif
