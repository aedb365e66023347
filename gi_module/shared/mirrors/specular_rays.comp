#version 450 core
// A ray for each pixel that mirrors or shows what is behind it. Of a cell of `grid` x `grid` pixels the first stands for the others
// where they show the same surface: those have none.
layout(local_size_x = 64) in;

#include "specular.glsl"
#include "specular_pixel.glsl"
#include "engine/gpu/work_items.glsl"

layout(std430, binding = 0) buffer Header { uint ray_count; uint ray_groups[3]; };
layout(std430, binding = 1) writeonly buffer Rays { SpecularRay rays[]; };
layout(std430, binding = 2) writeonly buffer Samples { SpecularSample samples[]; };
layout(std430, binding = 3) readonly buffer Pixels { uint pixel_count; uint pixel_groups[3]; uint pixels[]; };

uniform float origin_offset;

// A point each of a Hammersley set of 16 for the cells of every square of 4x4, of which each pixel's neighbours have all; so have the
// pixels of what differs from its cells.
uint lobe_number(ivec2 at) {
    uint x = uint(at.x & 3), y = uint(at.y & 3);
    return (x & 1u) | (y & 1u) << 1u | (x & 2u) << 1u | (y & 2u) << 2u;
}
vec2 lobe_numbers(uint i) {
    return (vec2(float(i), float(bitfieldReverse(i) >> 28u)) + 0.5) / 16.0;
}

void send(vec3 origin, vec3 direction, uint pixel, uint lobe, uint through, float density) {
    uint at = atomicAdd(ray_count, 1u);
    COUNT_GROUPS(ray_groups, at, at, 64u)
    rays[at] = SpecularRay(origin, pixel, direction, through + 2u * lobe);
    samples[2u * pixel + through] = SpecularSample(vec3(0.0), 0.0, direction, density);
}

// Whether the pixel's rays would bring what those of the first of its cell do.
bool stands_for(SpecularPixel first, SpecularPixel s, ivec2 q) {
    bool same_kind = mirrors(first) == mirrors(s) && shows_through(first) == shows_through(s) && same_width(first.alpha, s.alpha);
    return same_kind && (shows_through(s) ? same_pane(s, q) : same_surface(s, q));
}

void main() {
    uint i = work_item();
    if (i >= pixel_count) return;
    uint pixel = pixels[i];
    ivec2 p = ivec2(int(pixel) % image_size.x, int(pixel) / image_size.x);
    SpecularPixel s = specular_pixel(p);
    ivec2 cell = p / grid;
    if (grid > 1 && p != cell * grid && stands_for(specular_pixel(cell * grid), s, cell * grid)) return;
    uint lobe = lobe_number(p == cell * grid ? cell : p);
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
    if (shows_through(s)) send(s.position + s.towards * origin_offset, -s.towards, pixel, lobe, 1u, -1.0);
}
