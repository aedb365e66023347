#version 450 core
// Raises contrast between neighbours where there is little, up to what stays between black and white (Lottes 2019, "FidelityFX
// Contrast Adaptive Sharpening": the amount is the square root of the room over the largest, on the four neighbours).
layout(location = 0) out vec4 out_colour;

uniform sampler2D whole;  // upscale_resolve.frag
uniform float sharpness;  // 0..1

const float kMost = 0.2;  // of a neighbour, that is taken away

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(whole, 0) - 1;
    vec3 c = texelFetch(whole, p, 0).rgb;
    vec3 n = texelFetch(whole, ivec2(p.x, min(p.y + 1, last.y)), 0).rgb;
    vec3 s = texelFetch(whole, ivec2(p.x, max(p.y - 1, 0)), 0).rgb;
    vec3 e = texelFetch(whole, ivec2(min(p.x + 1, last.x), p.y), 0).rgb;
    vec3 w = texelFetch(whole, ivec2(max(p.x - 1, 0), p.y), 0).rgb;
    vec3 least = clamp(min(c, min(min(n, s), min(e, w))), 0.0, 1.0);
    vec3 most = clamp(max(c, max(max(n, s), max(e, w))), 0.0, 1.0);
    vec3 amount = sqrt(min(least, 1.0 - most) / max(most, vec3(1e-3)));
    vec3 lobe = -kMost * sharpness * clamp(amount, 0.0, 1.0);
    out_colour = vec4((c + lobe * (n + s + e + w)) / (1.0 + 4.0 * lobe), 1.0);
}
