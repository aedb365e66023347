// The share of even light that brdf.glsl reflects. The C++ side: brdf_table.h.
#ifndef LANTHORN_BRDF_TABLE_GLSL
#define LANTHORN_BRDF_TABLE_GLSL

uniform sampler2D brdf_table;

vec3 brdf_share(float nv, float roughness) {
    vec2 cells = vec2(textureSize(brdf_table, 0));
    vec2 place = clamp(vec2(nv, roughness), 0.0, 1.0) * (cells - 1.0) + 0.5;
    return textureLod(brdf_table, place / cells, 0.0).rgb;
}

// What a surface does with even light: shares of the specular lobe and of the diffuse part. `base`, `f0` as in brdf.glsl.
struct Reflectance {
    vec3 specular;
    vec3 diffuse;  // albedo
};

Reflectance reflectance(vec3 base, float metallic, float f0, vec3 share) {
    float f90 = min(50.0 * f0, 1.0);
    float dielectric = f0 * share.x + f90 * share.y;
    vec3 metal = base * share.x + share.y;
    Reflectance r;
    r.specular = mix(vec3(dielectric), metal, metallic);
    r.diffuse = base * ((1.0 - metallic) * (1.0 - f0 - (f90 - f0) * share.z));
    return r;
}

#endif
