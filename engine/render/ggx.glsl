// Directions of a GGX lobe and their densities (Heitz 2018, "Sampling the GGX Distribution of Visible Normals").
#ifndef LANTHORN_GGX_GLSL
#define LANTHORN_GGX_GLSL

const float kMirrorAlpha = 0.01;  // a lobe that is narrower than a pixel's share of the picture, about

float ggx_distribution(float nh, float a) {
    float a2 = a * a;
    float d = (nh * a2 - nh) * nh + 1.0;
    return a2 / (3.14159265359 * d * d);
}

// A normal of the microfacets that unit `v` sees, around unit `n`.
vec3 visible_normal(vec3 n, vec3 v, float a, vec2 u) {
    float s = n.z >= -1e-3 ? 1.0 : -1.0;
    float k = -1.0 / (s + n.z);
    float b = n.x * n.y * k;
    vec3 t = vec3(1.0 + s * n.x * n.x * k, s * b, -s * n.x);
    vec3 bt = vec3(b, s + n.y * n.y * k, -n.y);
    vec3 local = vec3(dot(v, t), dot(v, bt), max(dot(v, n), 1e-3));
    vec3 vh = normalize(vec3(a * local.xy, local.z));
    float across = dot(vh.xy, vh.xy);
    vec3 t1 = across > 1e-12 ? vec3(-vh.y, vh.x, 0.0) * inversesqrt(across) : vec3(1.0, 0.0, 0.0);
    vec3 t2 = cross(vh, t1);
    float r = sqrt(u.x);
    float phi = 6.28318530718 * u.y;
    float p1 = r * cos(phi);
    float w = 0.5 * (1.0 + vh.z);
    float p2 = (1.0 - w) * sqrt(max(1.0 - p1 * p1, 0.0)) + w * r * sin(phi);
    vec3 h = t1 * p1 + t2 * p2 + vh * sqrt(max(1.0 - p1 * p1 - p2 * p2, 0.0));
    h = normalize(vec3(a * h.xy, max(h.z, 1e-6)));
    return t * h.x + bt * h.y + n * h.z;
}

// Of the direction that visible_normal() mirrors v into: G1 D / (4 nv) (eq. 17).
float ggx_density(vec3 n, vec3 v, vec3 l, float a) {
    float nv = max(dot(n, v), 1e-3);
    float nh = clamp(dot(n, normalize(v + l)), 0.0, 1.0);
    float a2 = a * a;
    return ggx_distribution(nh, a) / (2.0 * (nv + sqrt(a2 + (1.0 - a2) * nv * nv)));
}

// Of the direction that a pixel's ray takes; a mirror's takes one alone.
float lobe_density(vec3 n, vec3 v, vec3 l, float a) {
    return a < kMirrorAlpha ? 1e12 : max(ggx_density(n, v, l, a), 1e-6);
}

// The lobe without its colour, times the cosine: D V cos.
float ggx_lobe(vec3 n, vec3 v, vec3 l, float a) {
    float nl = dot(n, l);
    float nv = max(dot(n, v), 1e-3);
    float nh = clamp(dot(n, normalize(v + l)), 0.0, 1.0);
    float a2 = a * a;
    float both = nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2);
    return nl > 0.0 ? ggx_distribution(nh, a) * 0.5 / both * nl : 0.0;
}

#endif
