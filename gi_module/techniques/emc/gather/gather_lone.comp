#version 450 core
// The listed pixels, whose surface none of the four points around shows: the mean of those of the sixteen around that do, else
// what the most alike of them has.
layout(local_size_x = 256) in;

#include "point_lists.glsl"
#include "gi_module/techniques/emc/splat/splat_surface.glsl"
#include "gather_surface.glsl"

layout(rgba32f, binding = 0) uniform writeonly image2D picture;
layout(std430, binding = 6) readonly buffer Listed { uint listed_count; uint listed_groups[3]; uint list[]; };

uniform samplerBuffer points;
uniform samplerBuffer irradiance;  // lux; a < 0: nothing is known
uniform ivec2 grid;

void main() {
    uint item = work_item();
    if (item >= listed_count) return;
    int entry = int(list[item]);
    ivec2 pixel = ivec2(entry % image_size.x, entry / image_size.x);
    vec3 x;
    vec3 n;
    float slack = 1e-4 * surface_at(pixel, x, n);
    ivec2 base = ivec2(floor((vec2(pixel) - float(stride / 2)) / float(stride)));
    vec4 around = vec4(0.0);
    vec4 any = vec4(0.0);
    for (int k = 0; k < 16; ++k) {
        ivec2 q = base + ivec2(k % 4, k / 4) - 1;
        bool inside = all(greaterThanEqual(q, ivec2(0))) && all(lessThan(q, grid));
        q = clamp(q, ivec2(0), grid - 1);
        int at = q.y * grid.x + q.x;
        vec4 e = texelFetch(irradiance, at);
        vec4 point = texelFetch(points, at);
        vec3 m = point_normal(point);
        bool known = inside && e.a >= 0.0;
        vec3 delta = point.xyz - x;
        float alike = known ? max(dot(n, m), 1e-3) / (dot(delta, delta) + slack * slack) : 0.0;
        around += vec4(e.rgb, 1.0) * (known ? same_surface(x, n, point.xyz, m, slack) : 0.0);
        any = alike > any.a ? vec4(e.rgb, alike) : any;
    }
    imageStore(picture, pixel, vec4(around.a > 1e-3 ? around.rgb / around.a : any.rgb, 0.0));
}
