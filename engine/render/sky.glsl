// The sky's radiance by direction. The C++ sides: sky_texture.h, engine/scene/include/lanthorn/scene/sky.h.
#ifndef LANTHORN_SKY_GLSL
#define LANTHORN_SKY_GLSL

uniform sampler2D sky_image;  // equirectangular, the first row at the zenith
uniform vec3 sky_scale;       // nits of 1 in it
uniform mat3 render_to_sky;

// From a unit direction in render space, in nits.
vec3 sky_radiance(vec3 direction) {
    vec3 d = render_to_sky * direction;
    // At the poles every longitude is right, but atan(0, 0) is undefined.
    float longitude = abs(d.y) < 0.9999999 ? atan(d.z, d.x) : 0.0;
    vec2 place = vec2(0.5 + longitude * 0.15915494309, acos(clamp(d.y, -1.0, 1.0)) * 0.31830988618);
    return textureLod(sky_image, place, 0.0).rgb * sky_scale;
}

#endif
