#version 450 core
// What a pixel mirrors and shows, of its own ray and of its neighbours' on the same surface, each by what it means to this pixel's
// lobe (Stachowiak 2015, "Stochastic Screen-Space Reflections"): the mean radiance in the lobe, times the share that it reflects.
layout(local_size_x = 64) in;

#include "specular.glsl"
#include "specular_pixel.glsl"
#include "gi_module/work_items.glsl"

layout(std430, binding = 2) readonly buffer Samples { SpecularSample samples[]; };
layout(std430, binding = 3) readonly buffer Pixels { uint pixel_count; uint pixel_groups[3]; uint pixels[]; };
layout(rgba32f, binding = 0) writeonly uniform image2D specular;

// All 16 numbers of the lobe are found within two cells, those at both rims twice.
float rim_weight(int x, int y) { return (abs(x) == 2 ? 0.5 : 1.0) * (abs(y) == 2 ? 0.5 : 1.0); }

bool outside(ivec2 q) { return any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, image_size)); }

SpecularSample sample_of(ivec2 q, int through) { return samples[2 * (q.y * image_size.x + q.x) + through]; }

// What the pixel's ray has brought, and by way of lobes on the way the mean of neighbours, each of which has taken one direction.
// Those without such a way leave their share to the pixel's own: so none of the light counts twice or is lost.
vec3 brought(SpecularPixel s, ivec2 p, SpecularSample own, int through) {
    if (own.known != kSpread) return own.radiance;
    vec4 sum = vec4(0.0);
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            ivec2 q = (p / grid + ivec2(x, y)) * grid;
            if (outside(q)) continue;
            SpecularSample other = sample_of(q, through);
            bool tells = other.known == kSpread && other.density < 0.0 && same_surface(s, q);
            sum += vec4(tells ? other.lobe : own.lobe, 1.0) * rim_weight(x, y);
        }
    }
    return own.radiance + sum.rgb / sum.a;
}

// The same of a pixel that has no ray, between the four around whose first pixels have one: rgb, and how much of it is known. One of
// them stands for the pixel, and counts whatever the others are.
vec4 interpolated(SpecularPixel s, ivec2 p, int through) {
    ivec2 cell = p / grid;
    vec2 f = vec2(p - cell * grid) / float(grid);
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 q = (cell + ivec2(k & 1, k >> 1)) * grid;
        if (outside(q)) continue;
        SpecularSample other = sample_of(q, through);
        if (other.known == 0.0 || other.density >= 0.0 || !same_surface(s, q)) continue;
        vec2 w = mix(1.0 - f, f, vec2(k & 1, k >> 1));
        bool spread = other.known == kSpread;
        sum += vec4(other.radiance + (spread ? other.lobe : vec3(0.0)), 1.0) * (w.x * w.y);
        weights += w.x * w.y;
    }
    return sum / max(weights, 1e-6);
}

// What came through the pixel or off its mirror, and how much of it is known.
vec4 by_one_way(SpecularPixel s, ivec2 p, int through) {
    SpecularSample own = sample_of(p, through);
    if (own.known == 0.0 && p != p / grid * grid) return interpolated(s, p, through);
    return vec4(brought(s, p, own, through), min(own.known, 1.0));
}

// Neighbours' rays by what they mean to the pixel's own lobe: the mean radiance in it. a 0: there is none.
vec4 by_lobe(SpecularPixel s, ivec2 p) {
    vec4 sum = vec4(0.0);
    int reach = s.alpha < 0.04 ? 1 : 2;
    bool first = p == p / grid * grid;
    if (!first) {
        SpecularSample own = sample_of(p, 0);
        float w = own.known > 0.0 ? ggx_lobe(s.normal, s.towards, own.lobe, s.alpha) / own.density : 0.0;
        sum = own.known > 0.0 ? vec4(own.radiance, 1.0) * max(w, 1e-6) : vec4(0.0);
    }
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            ivec2 q = (p / grid + ivec2(x, y)) * grid;
            if (outside(q)) continue;
            SpecularSample other = sample_of(q, 0);
            bool own = first && x == 0 && y == 0;
            if (other.known == 0.0 || (other.density < 0.0 && !own)) continue;
            if (!own && !same_surface(s, q)) continue;
            float w = ggx_lobe(s.normal, s.towards, other.lobe, s.alpha) / other.density;
            sum += vec4(other.radiance, 1.0) * (own ? max(w, 1e-6) : w * rim_weight(x, y));
        }
    }
    return sum;
}

void main() {
    uint i = work_item();
    if (i >= pixel_count) return;
    ivec2 p = ivec2(int(pixels[i]) % image_size.x, int(pixels[i]) / image_size.x);
    SpecularPixel s = specular_pixel(p);
    vec4 result = vec4(0.0);
    if (mirrors(s)) {
        vec4 sum = s.alpha < kMirrorAlpha ? by_one_way(s, p, 0) : by_lobe(s, p);
        if (sum.a > 0.0) {
            bool mirror = s.alpha < kMirrorAlpha;
            vec3 radiance = mirror ? sum.rgb : sum.rgb / sum.a;
            result = vec4(radiance * s.specular * (s.occlusion * s.traced), s.traced);
        }
    }
    if (shows_through(s)) {
        vec4 through = by_one_way(s, p, 1);
        result.rgb += through.rgb * (through.a * s.through);
    }
    imageStore(specular, p, result);
}
