#version 450 core
// What a pixel mirrors and shows, of its own ray and of its neighbours' on the same surface, each by what it means to this pixel's
// lobe (Stachowiak 2015, "Stochastic Screen-Space Reflections"): the mean radiance in the lobe, times the share that it reflects.
layout(local_size_x = 64) in;

#include "specular.glsl"
#include "specular_pixel.glsl"
#include "engine/gpu/work_items.glsl"

layout(std430, binding = 2) readonly buffer Samples { SpecularSample samples[]; };
layout(std430, binding = 3) readonly buffer Pixels { uint pixel_count; uint pixel_groups[3]; uint pixels[]; };
layout(rgba32f, binding = 0) writeonly uniform image2D specular;

// All 16 numbers of the lobe are found within two cells, those at both rims twice.
float rim_weight(int x, int y) { return (abs(x) == 2 ? 0.5 : 1.0) * (abs(y) == 2 ? 0.5 : 1.0); }

bool outside(ivec2 q) { return any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, image_size)); }

SpecularSample sample_of(ivec2 q, int through) { return samples[2 * (q.y * image_size.x + q.x) + through]; }

// Whether what a pixel shows by this way is, but for its own place, what q shows.
bool alike(SpecularPixel s, ivec2 q, int through) { return through == 1 ? same_pane(s, q) : same_surface(s, q); }

// By way of lobes on the way the mean of neighbours, each of which has taken one direction. Those without such a way leave their share
// to the pixel's own: so none of the light counts twice or is lost.
vec3 mean_lobe(SpecularPixel s, ivec2 cell, vec3 own, int through) {
    vec4 sum = vec4(0.0);
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            ivec2 q = (cell + ivec2(x, y)) * grid;
            if (outside(q)) continue;
            SpecularSample other = sample_of(q, through);
            bool tells = other.known == kSpread && other.density < 0.0 && alike(s, q, through);
            sum += vec4(tells ? other.lobe : own, 1.0) * rim_weight(x, y);
        }
    }
    return sum.rgb / sum.a;
}

// What the pixel's ray has brought.
vec3 brought(SpecularPixel s, ivec2 p, SpecularSample own, int through) {
    return own.radiance + (own.known == kSpread ? mean_lobe(s, p / grid, own.lobe, through) : vec3(0.0));
}

// The same of a pixel that has no ray, between the four around whose first pixels have one: rgb, and how much of it is known. One of
// them stands for the pixel.
vec4 interpolated(SpecularPixel s, ivec2 p, int through) {
    ivec2 cell = p / grid;
    vec2 f = vec2(p - cell * grid) / float(grid);
    vec4 sum = vec4(0.0), spread = vec4(0.0);
    for (int k = 0; k < 4; ++k) {
        ivec2 q = (cell + ivec2(k & 1, k >> 1)) * grid;
        if (outside(q)) continue;
        SpecularSample other = sample_of(q, through);
        if (other.known == 0.0 || other.density >= 0.0 || !alike(s, q, through)) continue;
        vec2 w = mix(1.0 - f, f, vec2(k & 1, k >> 1));
        sum += vec4(other.radiance, 1.0) * (w.x * w.y);
        if (other.known == kSpread) spread += vec4(other.lobe, 1.0) * (w.x * w.y);
    }
    if (spread.a > 0.0) sum.rgb += spread.a * mean_lobe(s, cell, spread.rgb / spread.a, through);
    return sum.a > 0.0 ? vec4(sum.rgb / sum.a, 1.0) : vec4(0.0);
}

// What came through the pixel or off its mirror, and how much of it is known.
vec4 by_one_way(SpecularPixel s, ivec2 p, int through) {
    SpecularSample own = sample_of(p, through);
    if (own.known == 0.0 && p != p / grid * grid) return interpolated(s, p, through);
    return vec4(brought(s, p, own, through), min(own.known, 1.0));
}

// What a ray means to the pixel's own lobe. No more than one of its own there: a ray of a much wider lobe would outweigh all others.
float meaning(SpecularPixel s, SpecularSample ray) {
    return ggx_lobe(s.normal, s.towards, ray.lobe, s.alpha) / max(ray.density, lobe_density(s.normal, s.towards, ray.lobe, s.alpha));
}

// Neighbours' rays by what they mean to the pixel's own lobe: the mean radiance in it. a 0: there is none. What has no ray, or the one
// that its cell shares, looks at cells around it; what differs from its cell looks at pixels, for its like.
vec4 by_lobe(SpecularPixel s, ivec2 p) {
    vec4 sum = vec4(0.0);
    int reach = s.alpha < 0.04 ? 1 : 2;
    ivec2 corner = p / grid * grid;
    bool has_own = sample_of(p, 0).known > 0.0;
    ivec2 middle = has_own ? p : corner;
    int step = middle == corner ? grid : 1;
    for (int y = -reach; y <= reach; ++y) {
        for (int x = -reach; x <= reach; ++x) {
            ivec2 q = middle + ivec2(x, y) * step;
            if (outside(q)) continue;
            SpecularSample other = sample_of(q, 0);
            bool own = has_own && q == p;
            if (other.known == 0.0 || (other.density < 0.0 && !own)) continue;
            if (!own && !same_surface(s, q)) continue;
            float w = meaning(s, other);
            sum += vec4(other.radiance, 1.0) * (q == middle ? max(w, 1e-6) : w * rim_weight(x, y));
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
