// What GBuffer::material() says in its fourth channel.
#ifndef LANTHORN_GBUFFER_FLAGS_GLSL
#define LANTHORN_GBUFFER_FLAGS_GLSL

// 1: unlit; 2 to 126: lets light of one of 125 colours through, by the nearest of five square roots a channel; 255: covered with
// fuzz (rim.glsl), and neither; 0: none of it.
float gbuffer_flags(bool unlit, float transmission, vec3 tint) {
    vec3 step = floor(4.0 * sqrt(clamp(tint, 0.0, 1.0)) + 0.5);
    float colour = 2.0 + step.r + 5.0 * step.g + 25.0 * step.b;
    return (unlit ? 1.0 : transmission > 0.0 ? colour : 0.0) / 255.0;
}

bool flags_say_unlit(float flags) { return flags > 0.0 && flags < 1.5 / 255.0; }
bool flags_say_rim(float flags) { return flags > 254.5 / 255.0; }

#endif
