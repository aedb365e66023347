// The metallic-roughness BRDF of glTF 2.0, appendix B, but for the diffuse part: there it keeps what Fresnel leaves at the half
// vector, which with the lobe makes up to 1.8 of the light that arrives at grazing angles. Here it keeps what Fresnel leaves on the
// way in and on the way out: no more than all, and reciprocal.
#ifndef LANTHORN_BRDF_GLSL
#define LANTHORN_BRDF_GLSL

// BRDF times 1 (no cosine), of its specular lobe `lobe` times: Lambert under Schlick's Fresnel, GGX with height-correlated Smith visibility (Heitz 2014).
// `base`: base colour, `f0`: reflectance of the dielectric part at normal incidence, `roughness`: perceptual.
vec3 metallic_roughness_brdf(vec3 base, float metallic, float roughness, float f0, vec3 n, vec3 v, vec3 l,
                             float lobe) {
    vec3 h = normalize(v + l);
    float nl = max(dot(n, l), 1e-4);
    float nv = max(dot(n, v), 1e-4);
    float nh = clamp(dot(n, h), 0.0, 1.0);
    float vh = clamp(dot(v, h), 0.0, 1.0);
    float a = max(roughness * roughness, 2e-3);
    float a2 = a * a;
    float d = (nh * a2 - nh) * nh + 1.0;
    float distribution = a2 / (3.14159265359 * d * d);
    float visibility = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2));
    vec3 s = 1.0 - min(vec3(vh, nl, nv), vec3(1.0));
    vec3 s5 = s * s;
    s5 *= s5 * s;
    // A dielectric without any specular reflection has none at grazing angles either.
    vec3 dielectrics = f0 + (min(50.0 * f0, 1.0) - f0) * s5;
    float dielectric = dielectrics.x;
    vec3 metal = base + (1.0 - base) * s5.x;
    vec3 diffuse = base * ((1.0 - metallic) * (1.0 - dielectrics.y) * (1.0 - dielectrics.z) * 0.31830988618);
    return diffuse + mix(vec3(dielectric), metal, metallic) * (distribution * visibility * lobe);
}

#endif
