#version 450 core
// The air's light of a pixel from the nine tiles around it, most from those whose rays went as far. Their weights are those of a
// bilinear look-up into means of 2 x 2 tiles, so that the four places of air.frag count alike.
#include "gbuffer_flags.glsl"

layout(location = 0) out vec4 out_radiance;

uniform sampler2D gbuffer_distance;
uniform sampler2D gbuffer_material;
uniform sampler2D air;
uniform float reach;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float seen = texelFetch(gbuffer_distance, pixel, 0).r;
    out_radiance = vec4(0.0);
    if (seen > 0.0 && flags_say_unlit(texelFetch(gbuffer_material, pixel, 0).a)) return;
    float far = seen > 0.0 ? seen : reach;
    vec2 t = (vec2(pixel) - 2.0) * 0.25 + 0.5;  // a tile's ray is that of its pixel (2, 2)
    ivec2 middle = ivec2(floor(t));
    vec2 f = t - vec2(middle);
    ivec2 last = textureSize(air, 0) - 1;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int k = 0; k < 9; ++k) {
        ivec2 step = ivec2(k % 3, k / 3) - 1;
        vec4 tile = texelFetch(air, clamp(middle + step, ivec2(0), last), 0);
        vec2 share = mix(mix(1.0 - f, vec2(1.0), equal(step, ivec2(0))), f, equal(step, ivec2(1)));
        float weight = (share.x * share.y + 1e-4) / (0.02 + abs(tile.a - far) / far);
        sum += weight * tile.rgb;
        weights += weight;
    }
    out_radiance = vec4(sum / weights, 0.0);
}
