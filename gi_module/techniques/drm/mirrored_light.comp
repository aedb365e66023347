#version 450 core
// Which texels of the lights' pictures show what sends light on, and the ray of each.
layout(local_size_x = 64) in;

#include "picture_look.glsl"
#include "gi_module/shared/mirrors/specular.glsl"

layout(std430, binding = 0) buffer Header { uint ray_count; };
layout(std430, binding = 1) writeonly buffer Rays { SpecularRay rays[]; };

uniform int width;  // texels a side of a picture

void main() {
    uint all = uint(width * width), p = gl_WorkGroupID.y, texel = gl_GlobalInvocationID.x;
    if (texel >= all) return;
    uint i = p * all + texel;
    PictureRay ray = picture_ray(pictures[p], lights[p], (vec2(texel % uint(width), texel / uint(width)) + 0.5) / float(width));
    bool on;
    Seen seen = look_along(p, ray, 1.0 / float(all), on);
    if (!on || ray.lumen == vec3(0.0)) return;
    // From half way on: what the lamp itself is made of does not stand in the way.
    vec3 origin = lights[p].position + ray.offset + ray.direction * (0.5 * seen.along);
    // Of a lobe's 16 directions another one in every texel of a square of 4 x 4.
    uvec2 at = uvec2(texel % uint(width), texel / uint(width));
    uint lobe = (at.x & 1u) | (at.y & 1u) << 1u | (at.x & 2u) << 1u | (at.y & 2u) << 2u;
    rays[atomicAdd(ray_count, 1u)] = SpecularRay(origin, i, ray.direction, 2u * lobe);
}
