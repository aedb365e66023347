#version 450 core
// Which pixels mirror or show what is behind them, and a ray each.
layout(local_size_x = 8, local_size_y = 8) in;

#include "specular.glsl"
#include "specular_pixel.glsl"
#include "gi_module/work_items.glsl"

layout(std430, binding = 0) buffer Header { uint ray_count; uint ray_groups[3]; };
layout(std430, binding = 1) writeonly buffer Rays { SpecularRay rays[]; };
layout(std430, binding = 2) writeonly buffer Samples { SpecularSample samples[]; };
layout(std430, binding = 3) buffer Pixels { uint pixel_count; uint pixel_groups[3]; uint pixels[]; };  // that have a ray

uniform float origin_offset;

// A point each of a Hammersley set of 16 for the pixels of every square of 4x4, of which each pixel's neighbours have all.
uint lobe_number(ivec2 p) {
    uint x = uint(p.x & 3), y = uint(p.y & 3);
    return (x & 1u) | (y & 1u) << 1u | (x & 2u) << 1u | (y & 2u) << 2u;
}
vec2 lobe_numbers(uint i) {
    return (vec2(float(i), float(bitfieldReverse(i) >> 28u)) + 0.5) / 16.0;
}

void send(vec3 origin, vec3 direction, uint pixel, uint lobe, uint through, float density) {
    uint at = atomicAdd(ray_count, 1u);
    uint group = at / 64u;
    atomicMax(ray_groups[0], min(group + 1u, kRow));
    atomicMax(ray_groups[1], group / kRow + 1u);
    rays[at] = SpecularRay(origin, pixel, direction, through + 2u * lobe);
    samples[2u * pixel + through] = SpecularSample(vec3(0.0), 0.0, direction, density);
}

void list(uint pixel) {
    uint at = atomicAdd(pixel_count, 1u);
    uint group = at / 64u;
    atomicMax(pixel_groups[0], min(group + 1u, kRow));
    atomicMax(pixel_groups[1], group / kRow + 1u);
    pixels[at] = pixel;
}

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, image_size))) return;
    uint pixel = uint(p.y * image_size.x + p.x);
    SpecularPixel s = specular_pixel(p);
    uint lobe = lobe_number(p);
    samples[2u * pixel].known = 0.0;
    samples[2u * pixel + 1u].known = 0.0;
    if (mirrors(s)) {
        bool mirror = s.alpha < kMirrorAlpha;
        vec3 h = mirror ? s.normal : visible_normal(s.normal, s.towards, s.alpha, lobe_numbers(lobe));
        vec3 l = reflect(-s.towards, h);
        // Below the surface itself: as far above its horizon.
        float below = dot(l, s.geometric);
        l = below > 1e-3 ? l : normalize(l + s.geometric * (1e-3 - 2.0 * min(below, 0.0)));
        float density = mirror ? -1.0 : lobe_density(s.normal, s.towards, l, s.alpha);
        send(s.position + s.geometric * origin_offset, l, pixel, lobe, 0u, density);
    }
    if (mirrors(s) || shows_through(s)) list(pixel);
    if (shows_through(s)) send(s.position + s.towards * origin_offset, -s.towards, pixel, lobe, 1u, -1.0);
}
