// The share of even light that brdf.glsl reflects. The C++ side: brdf_table.h.
#ifndef LANTHORN_BRDF_TABLE_GLSL
#define LANTHORN_BRDF_TABLE_GLSL

uniform sampler2D brdf_table;

vec2 brdf_share(float nv, float roughness) {
    vec2 cells = vec2(textureSize(brdf_table, 0));
    vec2 place = clamp(vec2(nv, roughness), 0.0, 1.0) * (cells - 1.0) + 0.5;
    return textureLod(brdf_table, place / cells, 0.0).rg;
}

// What a surface does with even light: the share of it that the specular lobe reflects, and the diffuse albedo. `base`, `f0` as in
// brdf.glsl, `share`: brdf_share() at nv.
struct Reflectance {
    vec3 specular;
    vec3 diffuse;
};

Reflectance reflectance(vec3 base, float metallic, float f0, float nv, vec2 share) {
    float rise = min(50.0 * f0, 1.0) - f0;
    float s = 1.0 - clamp(nv, 0.0, 1.0);
    float s2 = s * s;
    float lobe = f0 * share.x + min(50.0 * f0, 1.0) * share.y;
    Reflectance r;
    r.specular = mix(vec3(lobe), base * share.x + share.y, metallic);
    // Over all directions that light comes from the mean of (1 - nl)^5 is 1 / 21.
    r.diffuse = base * ((1.0 - metallic) * (1.0 - f0 - rise * s2 * s2 * s) * (1.0 - f0 - rise / 21.0));
    return r;
}

#endif
