// Light along the outlines of what is covered with fuzz (Look::rim): a thin layer that scatters evenly what comes from behind and
// from around is seen where the view grazes it, since there it is looked through at length (Koenderink and Pont 2003, "The
// secret of velvety skin"). What comes from behind is read off the picture, beyond the outline. Behind composite_state.glsl.
#ifndef LANTHORN_RIM_GLSL
#define LANTHORN_RIM_GLSL
#include "camera.glsl"
#include "gbuffer_flags.glsl"
#include "octahedral.glsl"

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_normals;
uniform sampler2D gbuffer_material;
uniform float rim_depth;  // optical depth of the layer, looked at squarely

// `radiance`: the picture's, nits; `pixel` and its centre, 0..1 from the lower left.
vec3 rim_light(sampler2D radiance, ivec2 pixel, vec2 centre) {
    const int kTaps = 6;
    const float kReach = 0.06;   // metres from one place beyond the outline to the next
    const float kBehind = 0.15;  // metres farther than the fuzz: what is nearer is it itself, or before it
    const float kBrightest = 8.0;  // times the light around: a lamp behind it is no wall of its brightness
    const float kAround = 0.6;   // of the light around, what comes where it is dark behind
    if (!flags_say_rim(texelFetch(gbuffer_material, pixel, 0).a)) return vec3(0.0);
    float distance = texelFetch(gbuffer_distance, pixel, 0).r;
    vec3 normal = octahedral_decode(texelFetch(gbuffer_normals, pixel, 0).xy);
    float facing = max(-dot(normal, pixel_direction(centre)), 0.12);
    // What is scattered where it is looked at squarely is part of its own colour.
    float share = exp(-rim_depth) - exp(-rim_depth / facing);
    vec2 out_of_it = vec2(dot(normal, normalize(camera_right)), dot(normal, normalize(camera_up)));
    float aside = length(out_of_it);
    ivec2 size = textureSize(radiance, 0);
    float metre = 0.5 * float(size.y) / (length(camera_up) * (camera_orthographic != 0 ? 1.0 : distance));  // pixels
    vec2 stride = aside > 1e-3 ? out_of_it / aside * max(metre * kReach, 1.0) : vec2(0.0);
    vec3 brightest = kBrightest * state.around.rgb;
    vec3 behind = vec3(0.0);
    for (int i = 1; i <= kTaps; ++i) {
        ivec2 at = clamp(pixel + ivec2(round(stride * float(i))), ivec2(0), size - 1);
        float there = texelFetch(gbuffer_distance, at, 0).r;
        vec4 light = texelFetch(radiance, at, 0);
        if ((there <= 0.0 || there > distance + kBehind) && light.a < 1.5) behind += min(light.rgb, brightest);
    }
    return share * max(behind / float(kTaps), kAround * state.around.rgb);
}

#endif
