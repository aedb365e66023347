#version 450 core
// The picture's light by tiles of 4 x 4 pixels: the mean of those inside it.
layout(location = 0) out vec4 out_light;

uniform sampler2D radiance;

void main() {
    ivec2 first = 4 * ivec2(gl_FragCoord.xy);
    ivec2 size = textureSize(radiance, 0);
    vec3 sum = vec3(0.0);
    float count = 0.0;
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            ivec2 at = first + ivec2(x, y);
            if (any(greaterThanEqual(at, size))) continue;
            vec4 texel = texelFetch(radiance, at, 0);
            if (texel.a < 1.5) sum += texel.rgb;  // unlit colours are no light
            count += 1.0;
        }
    }
    out_light = vec4(sum / count, 1.0);
}
