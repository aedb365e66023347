// The splats' kernel over the polygon that a surface fills around a point, and the weights that correct it there.
#ifndef LANTHORN_EMC_KERNEL_MOMENTS_GLSL
#define LANTHORN_EMC_KERNEL_MOMENTS_GLSL

// Moments of the kernel K = 2 / (pi h^2) (1 - r^2 / h^2) over the polygon, in units of bandwidth_max, at the four kNodes.
struct Moments {
    vec4 one, x, y, xx, xy, yy;  // integrals of K, K x, K y, K x^2 ...
};

// Adds the triangle of the centre and corners at `angle` and 45 degrees on, at radii a and b. Along a direction the integrals of
// K r, K r^2 and K r^3 over r are polynomials of the radius; over the angle, Gauss and Legendre's rule of four points.
void add_triangle(inout Moments m, float angle, float a, float b) {
    const vec2 kPlaces = vec2(0.86113631, 0.33998104);
    const vec2 kWeights = vec2(0.34785485, 0.65214515) * (0.5 * 0.78539816);
    vec4 h2 = 1.0 / kNodes;
    for (int i = 0; i < 4; ++i) {
        float place = i < 2 ? kPlaces[i] : -kPlaces[i - 2];
        float w = kWeights[i & 1];
        float s = 0.5 + 0.5 * place;
        float second = sin(0.78539816 * s);
        float first = sin(0.78539816 * (1.0 - s));
        float edge = 0.70710678 * a * b / max(second * a + first * b, 1e-9);  // radius of the polygon's edge
        vec4 r2 = min(vec4(edge * edge), h2);
        vec4 u = r2 / h2;
        vec4 k0 = (u - 0.5 * u * u) / 3.14159265359;
        vec4 r = sqrt(r2);
        vec4 k1 = 2.0 / 3.14159265359 * r * u * (1.0 / 3.0 - u / 5.0);
        vec4 k2 = 2.0 / 3.14159265359 * r2 * u * (1.0 / 4.0 - u / 6.0);
        float c = cos(angle + 0.78539816 * s);
        float q = sin(angle + 0.78539816 * s);
        m.one += w * k0;
        m.x += w * c * k1;
        m.y += w * q * k1;
        m.xx += w * c * c * k2;
        m.xy += w * c * q * k2;
        m.yy += w * q * q * k2;
    }
}

// Weights a + b x + c y by which the kernel is multiplied.
struct LinearWeights {
    vec4 constant, slope_x, slope_y;
};

// A share of the kernel's own second moment (1/6 of h^2 times its mass over a whole disc) that keeps b and c from swinging far
// where few photons are: 0 corrects whole, infinity not at all. Of 0, 0.02, 0.05, 0.1 and infinity, 0.1 had the least error against the
// reference in three of five scenes and 0.05 in two, by a percent.
const float kRidge = 0.1;

// So that the weighted kernel integrates to 1 and, up to the ridge, gives 0 for what is linear: local linear regression, which
// has no bias of first order where the disc is cut off (Fan and Gijbels 1996, Local Polynomial Modelling).
LinearWeights linear_weights(Moments m) {
    vec4 ridge = kRidge * m.one / kNodes;
    vec4 xx = m.xx + ridge;
    vec4 yy = m.yy + ridge;
    vec4 det = max(xx * yy - m.xy * m.xy, vec4(1e-30));
    vec4 b = (m.xy * m.y - yy * m.x) / det;
    vec4 c = (m.xy * m.x - xx * m.y) / det;
    // What is left of the mass is at least a share of it by Cauchy and Schwarz; a polygon of next to no area counts as 0.01 of
    // the disc, so that one photon on it stays finite.
    vec4 mass = max(m.one + b * m.x + c * m.y, 0.2 * max(m.one, vec4(0.01)));
    return LinearWeights(1.0 / mass, b / mass, c / mass);
}

#endif
