#version 450 core
// What a pixel mirrors and shows, of its own ray and of its neighbours' on the same surface, each by what it means to this pixel's
// lobe (Stachowiak 2015, "Stochastic Screen-Space Reflections"): the mean radiance in the lobe, times the share that it reflects.
layout(local_size_x = 8, local_size_y = 8) in;

#include "specular.glsl"
#include "specular_pixel.glsl"

layout(std430, binding = 2) readonly buffer Samples { SpecularSample samples[]; };
layout(rgba32f, binding = 0) writeonly uniform image2D specular;

const float kSameNormal = 0.95;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, image_size))) return;
    SpecularPixel s = specular_pixel(p);
    vec4 result = vec4(0.0);
    if (mirrors(s)) {
        vec4 sum = vec4(0.0);
        bool mirror = s.alpha < kMirrorAlpha;
        // All 16 numbers of the lobe are found within two pixels.
        int reach = mirror ? 0 : s.alpha < 0.04 ? 1 : 2;
        float tolerance = 0.02 * length(s.position - camera_position);
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                ivec2 q = p + ivec2(x, y);
                if (any(lessThan(q, ivec2(0))) || any(greaterThanEqual(q, image_size))) continue;
                SpecularSample other = samples[2 * (q.y * image_size.x + q.x)];
                bool own = x == 0 && y == 0;
                if (other.known == 0.0 || (other.density < 0.0 && !own)) continue;
                if (!own) {
                    vec2 uv = (vec2(q) + 0.5) / vec2(image_size);
                    vec3 there = render_position(uv, texelFetch(gbuffer_distance, q, 0).r);
                    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, q, 0).xy);
                    if (dot(normal, s.normal) < kSameNormal || abs(dot(there - s.position, s.geometric)) > tolerance) continue;
                }
                float w = mirror ? 1.0 : ggx_lobe(s.normal, s.towards, other.direction, s.alpha) / other.density;
                sum += vec4(other.radiance, 1.0) * (own ? max(w, 1e-6) : w);
            }
        }
        if (sum.a > 0.0) {
            result = vec4(sum.rgb / sum.a * s.specular * (s.occlusion * s.traced), s.traced);
        }
    }
    if (shows_through(s)) {
        SpecularSample through = samples[2 * (p.y * image_size.x + p.x) + 1];
        result.rgb += through.radiance * (through.known * s.through);
    }
    imageStore(specular, p, result);
}
