#version 450 core
// Direct irradiance of lit texels beside lamps: of a lamp that is nearer than kNear texel widths the mean over the texel, I Omega / A,
// by the solid angle Omega under which the lamp sees it (Van Oosterom and Strackee 1983).
layout(local_size_x = 256) in;

#include "engine/render/cube.glsl"
#include "lit_direct.glsl"

// What a lit texel shows, as a quad in its plane.
struct Quad {
    vec3 corners[4];
    float area;
};

Quad quad_of(int place, vec3 point, vec3 n) {
    int face = place / (lit_resolution * lit_resolution);
    vec2 p = vec2(place % lit_resolution, place / lit_resolution % lit_resolution);
    vec3 centre = centre_of_map(place);
    vec3 o = point - centre;
    float height = dot(o, n);  // < 0
    float most = 4.0 * length(o);
    Quad quad;
    for (int k = 0; k < 4; ++k) {
        vec3 u = normalize(cube_direction(face % 6, (p + vec2(k == 1 || k == 2 ? 1 : 0, k >> 1)) / float(lit_resolution)));
        quad.corners[k] = centre + u * min(height / min(dot(u, n), -1e-6), most);
    }
    quad.area = 0.5 * length(cross(quad.corners[2] - quad.corners[0], quad.corners[3] - quad.corners[1]));
    return quad;
}

float solid_angle(vec3 a, vec3 b, vec3 c) {
    vec3 l = vec3(length(a), length(b), length(c));
    float below = l.x * l.y * l.z + dot(a, b) * l.z + dot(a, c) * l.y + dot(b, c) * l.x;
    float above = abs(dot(a, cross(b, c)));
    return above > 0.0 ? 2.0 * atan(above, below) : 0.0;
}

// What a point's irradiance is of the illuminance there, of a lamp at `to_lamp` from it; near the lamp, the texel's.
float facing(vec3 to_lamp, vec3 point, vec3 n, Quad quad) {
    float r2 = dot(to_lamp, to_lamp);
    float cosine = dot(to_lamp, n) * inversesqrt(max(r2, 1e-30));
    if (!(r2 < kNear * kNear * quad.area) || cosine <= 0.0) return cosine;
    vec3 lamp = point + to_lamp;
    vec3 d[4] = vec3[4](quad.corners[0] - lamp, quad.corners[1] - lamp, quad.corners[2] - lamp, quad.corners[3] - lamp);
    return r2 * (solid_angle(d[0], d[1], d[2]) + solid_angle(d[0], d[2], d[3])) / quad.area;
}

vec3 punctual_irradiance(LightData light, vec3 point, vec3 normal, Quad quad) {
    vec3 l;
    float distance;
    vec3 illuminance = punctual_illuminance(light, point, l, distance);
    float visibility = punctual_visibility(light, point, normal, l, distance);
    bool far = light.type == kLightDirectional;
    float weight = visibility * (far ? dot(normal, l) : facing(light.position - point, point, normal, quad));
    return weight > 0.0 ? illuminance * weight : vec3(0.0);
}

vec3 texel_irradiance(int place, vec3 point, vec3 normal) {
    Quad quad = quad_of(place, point, normal);
    vec3 sum = vec3(0.0);
#ifdef LAMP_TREES
    LampTarget target = matte_target(point, normal);
#endif
#define ADD_TO_TEXEL(LIGHT) sum += punctual_irradiance(LIGHT, point, normal, quad);
    PUNCTUAL_LIGHTS(ADD_TO_TEXEL, target)
    return sum + area_irradiances(point, normal);
}

void main() {
    uint i = work_item();
    if (i >= listed_count) return;
    int place = int(list[i]);
    vec4 point = texelFetch(lit_points, place);
    set_direct(place, texel_irradiance(place, point.xyz, point_normal(point)), first[place].a);
}
