#version 450 core
// What a level keeps of its light, and what the wider ones hand back.
#include "bloom.glsl"

layout(location = 0) out vec4 out_light;

uniform sampler2D own;
uniform sampler2D wider;
uniform float spread;

void main() {
    vec3 light = texelFetch(own, ivec2(gl_FragCoord.xy), 0).rgb;
    if (spread > 0.0) light = mix(light, bloom_between(wider, 0.5 * gl_FragCoord.xy), spread);
    out_light = vec4(light, 1.0);
}
