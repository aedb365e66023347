#version 450 core
// What the drawn pixels say of the colours that may be around them, and, MOVING, of where they were and whether the frame before saw
// them. WITH_MOVERS: something else than the camera moved.
#include "camera.glsl"
#include "octahedral.glsl"
#include "upscale_colour.glsl"
#include "upscale_motion.glsl"

layout(location = 0) out vec4 out_mean;    // YCoCg of 3 x 3 pixels
layout(location = 1) out vec4 out_spread;  // their standard deviation; a: how well the past tells what they are, 0..1
#ifdef MOVING
layout(location = 2) out vec4 out_motion;  // xy: upscale_motion.glsl; z: 1 where the frame before saw the same surface

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform sampler2D distance_before;
uniform sampler2D normals_before;
uniform vec2 shift_before;
uniform sampler2D history;  // upscale_resolve.frag
#ifdef WITH_MOVERS
uniform sampler2D movers;
#endif

const float kSameDistance = 0.01;  // of it
const float kSameNormal = 0.8;     // cosine
const float kSameLight = 0.1;     // standard deviations that the past may be wrong by in the mean

// Whether the frame before saw, at `uv` or beside, a surface of that normal so far away.
bool was_seen(vec2 uv, float distance, float slack, vec3 normal) {
    vec2 size = vec2(textureSize(distance_before, 0));
    vec2 at = uv * size - shift_before - 0.5;
    ivec2 base = ivec2(floor(at));
    bool seen = false;
    for (int k = 0; k < 4; ++k) {
        ivec2 p = clamp(base + ivec2(k & 1, k >> 1), ivec2(0), ivec2(size) - 1);
        float there = texelFetch(distance_before, p, 0).r;
        vec3 n = octahedral_decode(texelFetch(normals_before, p, 0).zw);
        bool background = distance <= 0.0 && there <= 0.0;
        bool same = there > 0.0 && abs(there - distance) <= slack && dot(n, normal) > kSameNormal;
        seen = seen || background || same;
    }
    return seen;
}
#endif

uniform sampler2D picture;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(picture, 0) - 1;
    vec3 sum = vec3(0.0);
    vec3 squares = vec3(0.0);
#ifdef MOVING
    // What is nearest moves the edge (Karis 2014).
    float nearest = 3e38;
    ivec2 front = pixel;
#endif
    for (int k = 0; k < 9; ++k) {
        ivec2 p = clamp(pixel + ivec2(k % 3, k / 3) - 1, ivec2(0), last);
        vec3 c = ycocg(texelFetch(picture, p, 0).rgb);
        sum += c;
        squares += c * c;
#ifdef MOVING
        float d = texelFetch(gbuffer_distance, p, 0).r;
        bool nearer = d > 0.0 && d < nearest;
        nearest = nearer ? d : nearest;
        front = nearer ? p : front;
#endif
    }
    vec3 mean = sum / 9.0;
    out_mean = vec4(mean, 0.0);
    out_spread = vec4(sqrt(max(squares / 9.0 - mean * mean, vec3(0.0))), 1.0);
#ifdef MOVING
    vec2 size = vec2(last + 1);
    vec2 middle = vec2(front) + 0.5;
    float seen = texelFetch(gbuffer_distance, front, 0).r;
    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, front, 0).zw);
    vec2 uv = middle / size;
    vec3 ray = pixel_direction(uv);
    // The background is so far away that the camera's way does not count.
    vec3 relative = seen > 0.0 ? relative_position(uv, seen) + (camera_position - before_position) : ray * 1e6;
    vec3 motion = motion_from(middle, size, relative);
#ifdef WITH_MOVERS
    vec4 mover = texelFetch(movers, front, 0);
    motion = mover.a > 0.0 ? mover.xyz : motion;
#endif
    float cosine = max(abs(dot(normal, ray)), 0.05);
    float pixel_width = 2.0 * length(camera_up) / size.y * (camera_orthographic != 0 ? 1.0 : motion.z);
    float slack = kSameDistance * motion.z + 2.0 * pixel_width * sqrt(1.0 - min(cosine * cosine, 1.0)) / cosine;
    vec2 before = (gl_FragCoord.xy + shift) / size - motion.xy;
    bool inside = motion.z >= 0.0 && before == clamp(before, vec2(0.0), vec2(1.0));
    bool same = inside && was_seen(before, seen > 0.0 ? motion.z : 0.0, slack, normal);
    out_motion = vec4(motion.xy, same ? 1.0 : 0.0, 0.0);
    // Light that moves is no motion of what it falls on: it is told by what the past says of these very samples.
    float past = 0.0;
    for (int k = 0; k < 9; ++k) {
        ivec2 p = clamp(pixel + ivec2(k % 3, k / 3) - 1, ivec2(0), last);
        vec4 h = texture(history, (vec2(p) + 0.5 + shift) / size - motion.xy);
        past += is_bad(h) ? mean.x : dot(h.rgb, vec3(0.25, 0.5, 0.25));
    }
    float wrong = abs(past / 9.0 - mean.x) / (out_spread.x + 1.0 / 255.0);
    out_spread.a = 1.0 - smoothstep(kSameLight, 3.0 * kSameLight, wrong);
#endif
}
