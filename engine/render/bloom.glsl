// Between the texels of a level of the bloom's pyramid.
#ifndef LANTHORN_BLOOM_GLSL
#define LANTHORN_BLOOM_GLSL

// `place` in texels; bilinear, by fetches, since levels of odd sizes reach beyond the picture.
vec3 bloom_between(sampler2D level, vec2 place) {
    ivec2 last = textureSize(level, 0) - 1;
    vec2 t = place - 0.5;
    vec2 f = fract(t);
    ivec2 low = clamp(ivec2(floor(t)), ivec2(0), last);
    ivec2 high = clamp(ivec2(floor(t)) + 1, ivec2(0), last);
    vec3 below = mix(texelFetch(level, low, 0).rgb, texelFetch(level, ivec2(high.x, low.y), 0).rgb, f.x);
    vec3 above = mix(texelFetch(level, ivec2(low.x, high.y), 0).rgb, texelFetch(level, high, 0).rgb, f.x);
    return mix(below, above, f.y);
}

#endif
