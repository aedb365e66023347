#version 450 core
// Exposes, tone maps and encodes.
#include "composite_state.glsl"
#include "tone_map.glsl"

layout(location = 0) out vec4 out_colour;

uniform sampler2D radiance;
uniform int tone_map;  // ToneMap

void main() {
    vec4 texel = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0);
    vec3 c = texel.rgb;
    if (texel.a < 1.5) {  // unlit colours are shown as they are
        c = min(c * state.exposure, vec3(1e4));
        if (tone_map == 0) c = tone_map_aces(c);
        else if (tone_map == 1) c = tone_map_neutral(c);
    }
    out_colour = vec4(srgb_encode(c), 1.0);
}
