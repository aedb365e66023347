// Exposes, tone maps and encodes. WITH_BLOOM: a share of the light comes from around (bloom.h); WITH_RIM: fuzz shines (rim.glsl);
// WITH_SHOULDER: what is brighter than white is drawn together.
#include "composite_state.glsl"
#include "tone_map.glsl"
#ifdef WITH_BLOOM
#include "bloom.glsl"
#endif
#ifdef WITH_RIM
#include "rim.glsl"
#endif

uniform sampler2D radiance;
uniform int tone_map;  // ToneMap
#ifdef WITH_SHOULDER
uniform float shoulder;  // of white
#endif
#ifdef WITH_BLOOM
uniform sampler2D scattered;
uniform float scattered_share;
#endif

vec4 pixel_value(ivec2 pixel, vec2 centre) {
    vec4 texel = texelFetch(radiance, pixel, 0);
    vec3 c = texel.rgb;
    if (texel.a < 1.5) {  // unlit colours are shown as they are
#ifdef WITH_BLOOM
        c = mix(c, bloom_between(scattered, 0.25 * (vec2(pixel) + 0.5)), scattered_share);
#endif
#ifdef WITH_RIM
        c += rim_light(radiance, pixel, centre);
#endif
        c = min(c * state.exposure, vec3(1e4));
#ifdef WITH_SHOULDER
        c = draw_together(c, shoulder);
#endif
        if (tone_map == 0) c = tone_map_aces(c);
        else if (tone_map == 1) c = tone_map_neutral(c);
    }
    return vec4(srgb_encode(c), 1.0);
}

#include "pixel_pass.glsl"
