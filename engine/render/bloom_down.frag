#version 450 core
// Half as many texels: weights 1 3 3 1 each way, so that every texel above gives the same in all.
layout(location = 0) out vec4 out_light;

uniform sampler2D finer;

void main() {
    const float weight[4] = float[4](0.125, 0.375, 0.375, 0.125);
    ivec2 first = 2 * ivec2(gl_FragCoord.xy) - 1;
    ivec2 last = textureSize(finer, 0) - 1;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            ivec2 at = clamp(first + ivec2(x, y), ivec2(0), last);
            sum += texelFetch(finer, at, 0).rgb * (weight[x] * weight[y]);
        }
    }
    out_light = vec4(sum, 1.0);
}
