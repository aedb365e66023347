#version 450 core
// Raises contrast between neighbours where there is little, up to what stays between black and white (Lottes 2019, "FidelityFX
// Contrast Adaptive Sharpening": the amount is the square root of the room over the largest, on the four neighbours). Where some
// pixels know many samples and those beside them few, as in the first frames after a cut, one is drawn from all of them by what
// each knows (normalised convolution: Knutsson and Westin 1993): samples that lie on a lattice would show as dots.
layout(location = 0) out vec4 out_colour;

uniform sampler2D whole;  // upscale_resolve.frag
uniform float sharpness;  // 0..1

const float kMost = 0.2;    // of a neighbour, that is taken away
const float kFew = 0.5;    // samples of which a pixel alone is not sure
const float kEnough = 1.3;  // and of which it is
const float kOwn = 0.25;    // what a guess counts for, as in upscale_resolve.frag

vec4 at(ivec2 p) { return texelFetch(whole, clamp(p, ivec2(0), textureSize(whole, 0) - 1), 0); }

void main() {
    ivec2 p = ivec2(gl_FragCoord.xy);
    vec4 c = at(p);
    vec4 n = at(p + ivec2(0, 1));
    vec4 s = at(p - ivec2(0, 1));
    vec4 e = at(p + ivec2(1, 0));
    vec4 w = at(p - ivec2(1, 0));
    float together = 1.0 - smoothstep(kFew, kEnough, c.a);
    while (together > 0.0) {  // few pixels: where there is none this is not run through
        vec4 sum = vec4(0.0);
        float most_known = 0.0;
        for (int k = 0; k < 9; ++k) {
            ivec2 d = ivec2(k % 3, k / 3) - 1;
            vec4 there = at(p + d);
            // What is sure of itself may be of another surface, which has just been here.
            float known = d == ivec2(0) ? there.a : there.a * (1.0 - smoothstep(kFew, kEnough, there.a));
            most_known = max(most_known, known);
            sum += known * exp2(-float(d.x * d.x + d.y * d.y)) * vec4(there.rgb, 1.0);
        }
        together *= clamp(1.0 - c.a / max(most_known, 1e-3), 0.0, 1.0) + clamp(c.a - kOwn, 0.0, 1.0);
        together = min(together, 1.0);
        c.rgb = mix(c.rgb, sum.rgb / max(sum.a, 1e-6), together);
        break;
    }
    vec3 least = clamp(min(c.rgb, min(min(n.rgb, s.rgb), min(e.rgb, w.rgb))), 0.0, 1.0);
    vec3 most = clamp(max(c.rgb, max(max(n.rgb, s.rgb), max(e.rgb, w.rgb))), 0.0, 1.0);
    vec3 amount = sqrt(min(least, 1.0 - most) / max(most, vec3(1e-3)));
    vec3 lobe = -kMost * sharpness * (1.0 - together) * clamp(amount, 0.0, 1.0);
    out_colour = vec4((c.rgb + lobe * (n + s + e + w).rgb) / (1.0 + 4.0 * lobe), 1.0);
}
