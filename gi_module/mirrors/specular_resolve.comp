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

const float kSameNormal = 0.95;

// Whether pixel q shows the surface of p, nearly.
bool same_surface(SpecularPixel s, ivec2 q) {
    vec2 uv = (vec2(q) + 0.5) / vec2(image_size);
    vec3 there = render_position(uv, texelFetch(gbuffer_distance, q, 0).r);
    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, q, 0).xy);
    float tolerance = 0.02 * length(s.position - camera_position);
    return dot(normal, s.normal) >= kSameNormal && abs(dot(there - s.position, s.geometric)) <= tolerance;
}

// All 16 numbers of the lobe are found within two pixels, those at both rims twice.
float rim_weight(int x, int y) { return (abs(x) == 2 ? 0.5 : 1.0) * (abs(y) == 2 ? 0.5 : 1.0); }

// What the pixel's ray has brought, and by way of lobes on the way the mean of neighbours, each of which has taken one direction.
// Those without such a way leave their share to the pixel's own: so none of the light counts twice or is lost.
vec3 brought(SpecularPixel s, ivec2 p, int through) {
    SpecularSample own = samples[2 * (p.y * image_size.x + p.x) + through];
    if (own.known != kSpread) return own.radiance;
    vec4 sum = vec4(0.0);
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            ivec2 q = p + ivec2(x, y);
            if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, image_size))) continue;
            SpecularSample other = samples[2 * (q.y * image_size.x + q.x) + through];
            bool tells = other.known == kSpread && other.density < 0.0 && same_surface(s, q);
            sum += vec4(tells ? other.lobe : own.lobe, 1.0) * rim_weight(x, y);
        }
    }
    return own.radiance + sum.rgb / sum.a;
}

void main() {
    uint i = work_item();
    if (i >= pixel_count) return;
    ivec2 p = ivec2(int(pixels[i]) % image_size.x, int(pixels[i]) / image_size.x);
    SpecularPixel s = specular_pixel(p);
    vec4 result = vec4(0.0);
    if (mirrors(s)) {
        vec4 sum = vec4(0.0);
        bool mirror = s.alpha < kMirrorAlpha;
        int reach = mirror ? 0 : s.alpha < 0.04 ? 1 : 2;
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                ivec2 q = p + ivec2(x, y);
                if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, image_size))) continue;
                SpecularSample other = samples[2 * (q.y * image_size.x + q.x)];
                bool own = x == 0 && y == 0;
                if (other.known == 0.0 || (other.density < 0.0 && !own)) continue;
                if (!own && !same_surface(s, q)) continue;
                float w = mirror ? 1.0 : ggx_lobe(s.normal, s.towards, other.lobe, s.alpha) / other.density;
                sum += vec4(other.radiance, 1.0) * (own ? max(w, 1e-6) : w * rim_weight(x, y));
            }
        }
        if (mirror && sum.a > 0.0) sum = vec4(brought(s, p, 0), 1.0);
        if (sum.a > 0.0) {
            result = vec4(sum.rgb / sum.a * s.specular * (s.occlusion * s.traced), s.traced);
        }
    }
    if (shows_through(s)) {
        SpecularSample through = samples[2 * (p.y * image_size.x + p.x) + 1];
        result.rgb += brought(s, p, 1) * (min(through.known, 1.0) * s.through);
    }
    imageStore(specular, p, result);
}
