// Ordered dither: which pixels of a picture show a share of what covers them (Bayer 1973, "An optimum method for two-level
// rendition of continuous-tone pictures").
#ifndef LANTHORN_DITHER_GLSL
#define LANTHORN_DITHER_GLSL

// Over 4 x 4 pixels each of 1/32, 3/32, ... 31/32 once.
float dither_threshold(ivec2 pixel) {
    uvec2 p = uvec2(pixel);
    uint odd = p.x ^ p.y;
    uint place = (odd & 1u) << 3 | (p.y & 1u) << 2 | (odd & 2u) | (p.y & 2u) >> 1;
    return (float(place) + 0.5) / 16.0;
}

#endif
